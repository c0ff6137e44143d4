#include "tests/support/no_threads.h"
#include "texplorer/base/thrown.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/conform/report.h"
#include "texplorer/conform/sweep.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/image/linear_light.h"
#include "texplorer/image/stored_numbers.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>
#include <string>

namespace texplorer::conform::sweep_test {
namespace {

/// Draws each scene as the reference does, except for one error.
class Mutant : public Renderer {
public:
    using Change = void (*)(Scene&);
    using Blur = void (*)(Image&, const Scene&);
    explicit Mutant(Change change, Blur blur = nullptr)
        : change_(change)
        , blur_(blur) {}

    Result<Frame> draw(const Scene& scene) override {
        Scene changed = scene;
        if (change_)
            change_(changed);
        Result<Frame> frame = reference_->draw(changed);
        if (frame && blur_)
            blur_(frame->image, scene);
        return frame;
    }

private:
    Change change_;
    Blur blur_;
    std::unique_ptr<Renderer> reference_ = referenceRenderer();
};

/// Draws each scene as the reference does, but stores other texels.
class OtherTexels : public Renderer {
public:
    using Store = void (*)(std::array<int, 4>& texel, const FormatFacts& facts);
    explicit OtherTexels(Store store)
        : store_(store) {}

    Result<Frame> draw(const Scene& scene) override {
        Scene changed = scene;
        ImageSource images;
        for (std::size_t i = 0; i < changed.textures.size(); ++i) {
            Texture& texture = changed.textures[i];
            images.put(std::to_string(i), stored(texture));
            texture.source = SourceKind::File;
            texture.file = std::to_string(i);
            texture.mipmaps = MipPolicy::FromFile;
        }
        return referenceRendererWith(images)->draw(changed);
    }

private:
    /// The changed levels of the texture, before they are rounded.
    [[nodiscard]] TextureImage stored(const Texture& texture) const {
        Texture plain = texture;
        plain.internalFormat = InternalFormat::Rgba;
        TextureImage file;
        const Result<TextureLevels> levels = prepareLevels(plain, *madeImages().find(texture));
        for (const TextureLevel& level : levels->levels) {
            Image image = std::get<Image>(*level.surface);
            EXPECT_EQ(image.format, PixelFormat::Rgba8);
            for (std::size_t at = 0; at < image.pixels.size(); at += 4) {
                std::array<int, 4> texel{};
                for (std::size_t c = 0; c < 4; ++c)
                    texel[c] = std::to_integer<int>(image.pixels[at + c]);
                store_(texel, factsOf(texture.internalFormat));
                for (std::size_t c = 0; c < 4; ++c)
                    image.pixels[at + c] = static_cast<std::byte>(texel[c]);
            }
            file.surfaces.emplace_back(std::move(image));
        }
        file.levels = static_cast<int>(file.surfaces.size());
        return file;
    }

    Store store_;
};

/// The byte of an amount of light.
int lightOf(int byte) {
    return static_cast<int>(
        std::lround(255 * LinearLight::table().exactLight.at(static_cast<std::size_t>(byte))));
}

SweepOptions optionsFor(const std::vector<const Feature*>& features, int scenes) {
    SweepOptions options;
    options.selection = {1, scenes, features};
    options.pairs = {Pair{RendererKind::Reference, RendererKind::Shader}};
    options.driver.name = "llvmpipe"; // the rows of skips list its differences
    return options;
}

TEST(Sweep, FindsThatTheReferenceAgreesWithItself) {
    Mutant same(nullptr);
    const Result<Report> report = sweep(optionsFor({}, 120), {nullptr, &same});
    ASSERT_TRUE(report) << describe(report.error());
    EXPECT_TRUE(report->agrees());
    ASSERT_EQ(report->pairs.size(), 1U);
    EXPECT_EQ(report->pairs[0].outcomes.size(), features().size());
    for (const Outcome& outcome : report->pairs[0].outcomes) {
        EXPECT_EQ(outcome.all.over, 0U) << outcome.feature->name;
        EXPECT_EQ(outcome.all.max, 0) << outcome.feature->name;
    }
}

/// Draws as the reference does and reports a problem for each scene.
class Complainer : public Renderer {
public:
    explicit Complainer(std::vector<Sentence> problems)
        : problems_(std::move(problems)) {}
    Result<Frame> draw(const Scene& scene) override {
        Result<Frame> frame = reference_->draw(scene);
        frame->problems = problems_;
        return frame;
    }

private:
    std::vector<Sentence> problems_;
    std::unique_ptr<Renderer> reference_ = referenceRenderer();
};

TEST(Sweep, NamesTheProblemThatOnlyOneHas) {
    SweepOptions options = optionsFor({findFeature("wrap")}, 4);
    options.pairs = {Pair{RendererKind::Shader, RendererKind::Fixed}};
    const auto problemOf = [&](std::vector<Sentence> fixed, std::vector<Sentence> shader) {
        Complainer one(std::move(fixed));
        Complainer other(std::move(shader));
        return sweep(options, {&one, &other})->pairs[0].outcomes[0].problem;
    };
    EXPECT_EQ(problemOf({"of both"}, {"of both", "of the shader"}), "of the shader");
    EXPECT_EQ(problemOf({"of both", "of fixed"}, {"of both"}), "of fixed");
    EXPECT_EQ(problemOf({"of both", "and this"}, {"and this", "of both"}), "");
    EXPECT_EQ(problemOf({"of fixed"}, {}), "of fixed");
}

TEST(Sweep, IsTheSameWithAnyNumberOfThreads) {
    SweepOptions options = optionsFor({findFeature("wrap"), findFeature("trilinear")}, 40);
    std::vector<Report> reports;
    const auto compared = [&options] {
        Mutant biased([](Scene& scene) { scene.passes[0].units[0].lodBias += 0.05F; });
        return *sweep(options, {nullptr, &biased});
    };
    for (const unsigned threads : {1U, 3U}) {
        options.threads = threads;
        reports.push_back(compared());
    }
    {
        const test::NoThreads none; // available: the drawing thread compares
        reports.push_back(compared());
    }
    for (const Report& report : reports) {
        EXPECT_EQ(asJson(report), asJson(reports[0]));
        for (std::size_t i = 0; i < reports[0].pairs[0].outcomes.size(); ++i) {
            const std::optional<Worst>& one = reports[0].pairs[0].outcomes[i].worst;
            const std::optional<Worst>& other = report.pairs[0].outcomes[i].worst;
            ASSERT_TRUE(one && other);
            EXPECT_EQ(one->scene, other->scene);
            EXPECT_EQ(one->subject, other->subject);
            EXPECT_EQ(one->against, other->against);
        }
    }
}

TEST(Sweep, StopsWhenItIsAskedTo) {
    std::stop_source stop;
    SweepOptions options = optionsFor({}, 2000);
    options.stop = stop.get_token();
    options.progress = [&](float done) {
        if (done > 0.002F)
            stop.request_stop();
    };
    Mutant same(nullptr);
    const Result<Report> report = sweep(options, {nullptr, &same});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
}

class Broken : public Renderer {
public:
    Result<Frame> draw(const Scene& /*scene*/) override {
        return fail(ErrorCode::Driver, "the context is gone");
    }
};

TEST(Sweep, EndsWithTheErrorOfARendererThatCanNotDraw) {
    Broken broken;
    const Result<Report> report = sweep(optionsFor({}, 100), {nullptr, &broken});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().message, "the context is gone");
}

/// Throws after some scenes.
class Throwing : public Explainer {
public:
    explicit Throwing(int good)
        : good_(good) {}
    Result<Frame> drawBy(const Scene& scene, reference::RhoMethod rho) override {
        if (good_-- <= 0)
            throw std::runtime_error("the driver gave up");
        return reference_->drawBy(scene, rho);
    }
    Result<std::vector<reference::PixelBytes>> overLambda(const Scene& scene, reference::PixelPlace pixel,
                                                          RhoMethods methods) override {
        return reference_->overLambda(scene, pixel, methods);
    }
    const ImageSource& images() const override { return reference_->images(); }

private:
    int good_;
    std::unique_ptr<Explainer> reference_ = referenceRenderer();
};

// Neither thread may wait for the other after that.
TEST(Sweep, EndsWhereTheDrawingThrows) {
    for (const int good : {0, 5}) {
        Throwing throwing(good);
        const Result<Report> report = sweep(optionsFor({}, 100), {nullptr, &throwing});
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().message, "a renderer failed: " + std::string(ownMistake));
    }
}

TEST(Sweep, EndsWhereTheComparingThrows) {
    for (const int good : {0, 5}) {
        Mutant same(nullptr);
        SweepOptions options = optionsFor({}, 200); // more than the queue holds
        options.threads = 2;
        const Result<Report> report = sweep(
            options, {nullptr, &same, [good](const Driver&) { return std::make_unique<Throwing>(good); }});
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().message, "a renderer failed: " + std::string(ownMistake));
    }
}

// --- The scenes

TEST(Cases, AreTheSameForTheSameSeed) {
    const auto texts = [](unsigned seed, int scenes) {
        std::vector<std::string> all;
        for (const Case& item : casesOf({seed, scenes, {}}))
            all.push_back(std::string(item.feature->name) + std::to_string(item.number) +
                          writeScene(item.scene));
        return all;
    };
    EXPECT_EQ(texts(1, 100), texts(1, 100));
    EXPECT_NE(texts(1, 100), texts(2, 100));
    // More scenes are the same ones, followed by others.
    const std::vector<std::string> more = texts(1, 400);
    const std::set<std::string> known(more.begin(), more.end());
    for (const std::string& text : texts(1, 100))
        EXPECT_TRUE(known.contains(text));
}

TEST(Cases, AreAsManyAsAreAskedFor) {
    const auto countOf = [](const std::vector<Case>& cases, const Feature& feature) {
        return std::ranges::count(cases, &feature, &Case::feature);
    };
    const auto all = static_cast<int>(features().size());
    std::vector<Case> before;
    for (const int scenes : {1, all - 1, all, all + 1, 100, 600, 777}) {
        const std::vector<Case> cases = casesOf({1, scenes, {}});
        EXPECT_EQ(cases.size(), static_cast<std::size_t>(scenes));
        for (const Feature& feature : features()) {
            EXPECT_GE(countOf(cases, feature), countOf(before, feature)) << feature.name << " of " << scenes;
            EXPECT_TRUE(scenes < all || countOf(cases, feature) > 0) << feature.name << " of " << scenes;
        }
        before = cases;
    }
    const std::vector<Case> usual = casesOf({1, defaultScenes, {}});
    for (const Feature& feature : features())
        EXPECT_EQ(countOf(usual, feature), feature.scenes) << feature.name;
    EXPECT_EQ(casesOf({1, 7, {findFeature("wrap"), findFeature("lod")}}).size(), 7U);
}

// Level settings need not make sense: renderers must handle them.
TEST(Cases, HaveLevelSettingsWithAndWithoutSense) {
    bool beyond = false;
    bool backwards = false;
    bool limited = false;
    std::set<std::string> files;
    for (const Case& item : casesOf({1, 64, {findFeature("levels")}})) {
        const Texture& texture = item.scene.textures[0];
        beyond = beyond || texture.baseLevel > 100;
        backwards = backwards || texture.maxLevel < texture.baseLevel;
        limited = limited || (texture.minLod > -100 && texture.maxLod < 100);
        EXPECT_LE(texture.minLod, texture.maxLod); // else lambda is undefined
        if (texture.source == SourceKind::File)
            files.insert(texture.file);
    }
    EXPECT_TRUE(beyond && backwards && limited);
    EXPECT_EQ(files.size(), madeFiles.size());
    // The extents of a chain of 64 x 64: section 3.8.8, floor(n / 2^d).
    for (const auto& [name, levels] : madeFiles) {
        Texture texture;
        texture.source = SourceKind::File;
        texture.file = name;
        const auto image = madeImages().find(texture);
        ASSERT_TRUE(image) << name;
        ASSERT_EQ(image->levels, levels) << name;
        for (int level = 0; level < levels; ++level)
            EXPECT_EQ(widthOf(image->surface(0, level)), 64 >> level) << name;
    }
}

TEST(Cases, WrapCubeMapsInEachWay) {
    std::set<Wrap> wraps;
    for (const Case& item : casesOf({1, 64, {findFeature("cube-map")}}))
        wraps.insert({item.scene.textures[0].wrapS, item.scene.textures[0].wrapT});
    EXPECT_EQ(wraps.size(), EnumTable<Wrap>::rows.size());
}

// Lines that are clipped have other ends, and those of even width end elsewhere (skip.cpp).
TEST(Cases, HaveLinesOfEveryKindWithinTheView) {
    std::set<Primitive> primitives;
    std::set<float> widths;
    std::set<float> sizes;
    for (const Case& item : casesOf({1, 72, {findFeature("lines")}})) {
        const Model& model = item.scene.models[0];
        primitives.insert(model.mesh.primitive);
        widths.insert(model.lineWidth);
        sizes.insert(model.pointSize);
        const glm::mat4 toClip =
            projectionMatrix(item.scene.view, 1) * modelViewMatrix(item.scene.view, model, 0);
        for (const glm::vec3& position : model.mesh.positions) {
            const glm::vec4 clip = toClip * glm::vec4(position, 1);
            EXPECT_LT(std::max(std::abs(clip.x), std::abs(clip.y)), 0.89F * clip.w) << item.number;
        }
    }
    EXPECT_THAT(primitives, testing::ElementsAre(Primitive::Points, Primitive::Lines, Primitive::LineLoop,
                                                 Primitive::LineStrip));
    EXPECT_THAT(widths, testing::ElementsAre(1, 3, 5, 7));
    EXPECT_EQ(sizes.size(), 7U);
}

TEST(Cases, HaveAMeshWhereverAShapeIsDrawn) {
    for (const Case& item : casesOf({1, defaultScenes, {}})) {
        for (const Model& model : item.scene.models)
            EXPECT_GT(vertexCountOf(model), 0U) << item.feature->name << " " << item.number;
    }
}

TEST(Cases, NameModelsInAnyOrder) {
    bool all = false;
    std::set<std::vector<int>> named;
    for (const Case& item : casesOf({1, 60, {findFeature("passes")}})) {
        for (const Pass& pass : item.scene.passes) {
            all = all || pass.models.empty();
            named.insert(pass.models);
        }
    }
    EXPECT_TRUE(all);
    EXPECT_TRUE(std::ranges::any_of(named, [](const std::vector<int>& models) {
        return models.size() > 1 && !std::ranges::is_sorted(models);
    }));
}

TEST(Cases, PairEveryOperationOfTheMatrixWithEveryOther) {
    std::set<std::pair<MatrixOp, MatrixOp>> pairs;
    bool ofOneQ = false;
    bool ofManyQs = false;
    for (const Case& item : casesOf({1, 144, {findFeature("matrix")}})) {
        const std::vector<MatrixStep>& steps = item.scene.passes[0].units[0].matrix;
        pairs.insert({steps.at(0).op, steps.at(1).op});
        const TexCoords& coords = item.scene.models[0].texCoords[0];
        const bool even = std::ranges::all_of(coords, [](const glm::vec4& each) { return each.q == 1; });
        (even ? ofOneQ : ofManyQs) = true;
    }
    EXPECT_EQ(pairs.size(), matrixOpRows.size() * matrixOpRows.size());
    EXPECT_TRUE(ofOneQ && ofManyQs);
}

TEST(Cases, UploadEveryFormatThatFitsOrNot) {
    std::set<TransferFormat> formats;
    std::set<TransferType> types;
    std::set<int> alignments;
    int refused = 0;
    for (const Case& item : casesOf({1, 132, {findFeature("upload")}})) {
        const Texture& texture = item.scene.textures[0];
        formats.insert(texture.upload.format);
        types.insert(texture.upload.type);
        alignments.insert(texture.upload.alignment);
        const LevelPlan plan = planLevels(texture, madeImages().picturesOf(texture), Target::Texture2D);
        ASSERT_TRUE(plan.upload);
        refused += plan.upload->refusal.empty() ? 0 : 1;
    }
    EXPECT_EQ(formats.size(), transferFormatRows.size());
    EXPECT_EQ(types.size(), transferTypeRows.size());
    EXPECT_THAT(alignments, testing::ElementsAre(1, 2, 4, 8));
    EXPECT_EQ(refused, 0);
}

TEST(Skips, NameUploadsWhoseNumbersAreOpen) {
    constexpr Pair withReference{RendererKind::Reference, RendererKind::Fixed};
    Scene scene = sceneOf(*findFeature("upload"), 1, 0);
    Upload& upload = scene.textures[0].upload;
    upload = {.custom = true, .type = TransferType::Short};
    const auto nameOf = [&](const Pair& pair) {
        const Skip* skip = skipOf(scene, pair, {"any", "", "", {}});
        return skip ? skip->name : std::string_view();
    };
    EXPECT_EQ(nameOf(withReference), "signed-upload");
    EXPECT_EQ(nameOf({RendererKind::Fixed, RendererKind::Shader}), "");
    upload.type = TransferType::Float;
    EXPECT_EQ(nameOf(withReference), "float-upload");
    upload.memory = MemoryRows::Layout;
    upload.memoryType = TransferType::Float;
    EXPECT_EQ(nameOf(withReference), "");
    upload.custom = false;
    upload.type = TransferType::Short;
    EXPECT_EQ(nameOf(withReference), "");
}

TEST(Skips, NameLinesOfEvenWidthThatAreDrawn) {
    const Scene lines = sceneOf(*findFeature("lines"), 1, scenesPerState); // GL_LINES
    const auto nameOf = [](const Scene& scene, const Pair& pair, const char* driver) {
        const Skip* skip = skipOf(scene, pair, {driver, "", "", {}});
        return skip ? skip->name : std::string_view();
    };
    constexpr Pair withReference{RendererKind::Reference, RendererKind::Fixed};
    constexpr const char* mesa = "llvmpipe (LLVM 15)";
    for (const auto& [width, name] :
         {std::pair{1.0F, ""}, std::pair{1.4F, ""}, std::pair{1.6F, "even-lines"},
          std::pair{2.0F, "even-lines"}, std::pair{3.0F, ""}, std::pair{64.0F, "even-lines"}}) {
        Scene scene = lines;
        scene.models[0].lineWidth = width;
        EXPECT_EQ(nameOf(scene, withReference, mesa), name) << width;
        EXPECT_EQ(nameOf(scene, withReference, "another"), "") << width;
        EXPECT_EQ(nameOf(scene, {RendererKind::Shader, RendererKind::Fixed}, mesa), "") << width;
        scene.models[0].mesh.primitive = Primitive::Triangles;
        EXPECT_EQ(nameOf(scene, withReference, mesa), "") << width;
        scene.models[0].mesh.primitive = Primitive::LineLoop;
        scene.models[0].visible = false;
        EXPECT_EQ(nameOf(scene, withReference, mesa), "") << width;
    }
}

// std::mt19937 is the same everywhere. The seed is the FNV-1a hash of these; its first number was computed
// with Python.
TEST(Cases, AreTheSameOnEveryMachine) {
    Dice dice("environment", 1, 0);
    EXPECT_EQ(dice.below(1000000), 728812);
}

TEST(Cases, OfEachFeatureAreScenesThatAFileCanHold) {
    for (const Case& item : casesOf({1, 400, {}})) {
        const Result<Scene> read = parseScene(writeScene(item.scene));
        ASSERT_TRUE(read) << item.feature->name << " " << item.number << ": " << describe(read.error());
        EXPECT_EQ(*read, item.scene) << item.feature->name << " " << item.number;
    }
}

// A scene that cannot be drawn as specified would be compared with nothing.
TEST(Cases, AskForNothingThatIsMissing) {
    for (const Case& item : casesOf({1, 400, {}})) {
        if (item.feature->name == "incomplete")
            continue;
        for (const texplorer::Finding& each : diagnose(item.scene, madeImages()))
            EXPECT_NE(each.severity, Severity::Error)
                << item.feature->name << " " << item.number << ": " << each.path << ": " << each.sentence;
    }
}

TEST(Cases, OfAStateDifferInNumbersAlone) {
    for (const Feature& feature : features()) {
        for (int state = 0; state < 3; ++state) {
            const Scene first = sceneOf(feature, 1, state * scenesPerState);
            for (int i = 1; i < scenesPerState; ++i) {
                const Scene other = sceneOf(feature, 1, state * scenesPerState + i);
                ASSERT_EQ(other.passes.size(), first.passes.size()) << feature.name;
                ASSERT_EQ(other.textures.size(), first.textures.size()) << feature.name;
                for (std::size_t p = 0; p < first.passes.size(); ++p) {
                    for (std::size_t u = 0; u < maxUnits; ++u) {
                        const Unit& a = first.passes[p].units[u];
                        const Unit& b = other.passes[p].units[u];
                        EXPECT_EQ(a.enabled, b.enabled) << feature.name;
                        EXPECT_EQ(a.envMode, b.envMode) << feature.name;
                        EXPECT_EQ(a.combine, b.combine) << feature.name;
                        EXPECT_EQ(a.target, b.target) << feature.name;
                    }
                }
                for (std::size_t t = 0; t < first.textures.size(); ++t) {
                    EXPECT_EQ(first.textures[t].minFilter, other.textures[t].minFilter) << feature.name;
                    EXPECT_EQ(first.textures[t].wrapS, other.textures[t].wrapS) << feature.name;
                    EXPECT_EQ(first.textures[t].internalFormat, other.textures[t].internalFormat)
                        << feature.name;
                }
            }
        }
    }
}

TEST(Features, HaveUniqueNamesAndSomethingToSay) {
    std::set<std::string_view> names;
    for (const Feature& feature : features()) {
        EXPECT_TRUE(names.insert(feature.name).second) << feature.name;
        EXPECT_FALSE(feature.sweeps.empty() || feature.section.empty()) << feature.name;
        EXPECT_EQ(findFeature(feature.name), &feature);
    }
    EXPECT_EQ(findFeature("none"), nullptr);
}

// --- Renderers with an error: each must be caught by the feature that the error affects

void eachUnit(Scene& scene, auto change) {
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            change(unit);
    }
}
void eachTexture(Scene& scene, auto change) {
    for (Texture& texture : scene.textures)
        change(texture);
}
void eachModel(Scene& scene, auto change) {
    for (Model& model : scene.models)
        change(model);
}
void eachStep(Scene& scene, auto change) {
    eachUnit(scene, [&](Unit& unit) { std::ranges::for_each(unit.matrix, change); });
}

struct Wrong {
    const char* name;
    const char* feature;
    Mutant::Change change;
    Mutant::Blur blur = nullptr;
    int scenes = 40;                 ///< enough for each to be caught
    const char* driver = "llvmpipe"; ///< whose peculiarities the rows of skips name
};
class WrongRenderer : public testing::TestWithParam<Wrong> {};

/// The outcome of a sweep of one feature.
Outcome outcomeOf(Renderer& renderer, const char* name, int scenes, const char* driver) {
    const Feature* feature = findFeature(name);
    EXPECT_NE(feature, nullptr);
    SweepOptions options = optionsFor({feature}, scenes);
    options.driver.name = driver;
    const Result<Report> report = sweep(options, {nullptr, &renderer});
    EXPECT_TRUE(report) << describe(report.error());
    return report->pairs[0].outcomes[0];
}

TEST_P(WrongRenderer, IsCaughtByItsFeature) {
    Mutant mutant(GetParam().change, GetParam().blur);
    const Outcome outcome = outcomeOf(mutant, GetParam().feature, GetParam().scenes, GetParam().driver);
    EXPECT_EQ(outcome.verdict(), Verdict::Differ)
        << outcome.all.over << " of " << outcome.all.pixels << " pixels over, " << outcome.all.unexplained
        << " unexplained";
}

/// The verdict for scenes with these numbers of pixels above the bound, of 1000 each, all of them explained.
Verdict verdictOf(const std::vector<std::size_t>& overs) {
    Outcome outcome;
    outcome.rule = &rules::levelBlend; // allows 4 %
    for (const std::size_t over : overs) {
        Judgement judgement;
        judgement.difference.pixels = 1000;
        judgement.difference.over = over;
        outcome.all.add(judgement);
    }
    return outcome.verdict();
}

// 4 % is the limit for thousands of scenes: one may have more, and a few by chance.
TEST(Verdicts, DependOnTheNumberOfScenes) {
    EXPECT_EQ(verdictOf({}), Verdict::Skipped);
    EXPECT_EQ(verdictOf({39}), Verdict::Agree);
    EXPECT_EQ(verdictOf({200}), Verdict::TooFewScenes);
    EXPECT_EQ(verdictOf(std::vector<std::size_t>(18, 200)), Verdict::TooFewScenes);
    EXPECT_EQ(verdictOf(std::vector<std::size_t>(19, 200)), Verdict::Differ);
    std::vector<std::size_t> spread(72, 0); // 4.5 % on the average: chance
    for (std::size_t i = 0; i < spread.size(); i += 4)
        spread[i] = 180;
    EXPECT_EQ(verdictOf(spread), Verdict::Agree);
    EXPECT_EQ(verdictOf(std::vector<std::size_t>(72, 45)), Verdict::Differ); // the same in each is none
}

// If a rule allows nothing, a single pixel in a single scene is too much.
TEST(Verdicts, NeedNoSecondSceneWhereNothingIsAllowed) {
    Mutant wrong(nullptr, [](Image& image, const Scene&) { image.pixels[0] ^= std::byte{0x80}; });
    EXPECT_EQ(outcomeOf(wrong, "wrap", 1, "llvmpipe").verdict(), Verdict::Differ);
}

// A completely wrong scene is enough by itself.
TEST(Verdicts, NeedNoSecondSceneThatIsWrong) {
    Mutant wrong(nullptr,
                 [](Image& image, const Scene&) { std::ranges::fill(image.pixels, std::byte{0x55}); });
    EXPECT_EQ(outcomeOf(wrong, "linear", 1, "llvmpipe").verdict(), Verdict::Differ);
}

/// A driver with the smallest or the largest rho that is allowed.
class OtherRho : public Renderer {
public:
    explicit OtherRho(reference::RhoMethod method)
        : method_(method) {}
    Result<Frame> draw(const Scene& scene) override { return reference_->drawBy(scene, method_); }

private:
    reference::RhoMethod method_;
    std::unique_ptr<Explainer> reference_ = referenceRenderer();
};

TEST(Verdicts, AllowEitherEndOfRhoAndSaySo) {
    for (const auto method : {reference::RhoMethod::Lower, reference::RhoMethod::Upper}) {
        OtherRho driver(method);
        for (const char* feature : {"trilinear", "mipmap-nearest", "lod", "given-levels"}) {
            const Outcome outcome = outcomeOf(driver, feature, 24, "softpipe");
            EXPECT_EQ(outcome.verdict(), Verdict::Agree) << feature;
            EXPECT_EQ(outcome.all.unexplained, 0U) << feature;
            EXPECT_EQ(outcome.rho.size(), 1U) << feature;
            EXPECT_GT(outcome.rho.at(method), 0) << feature;
        }
    }
}

struct WrongStore {
    const char* name;
    OtherTexels::Store store;
    bool agrees = false;
};
class WrongTexels : public testing::TestWithParam<WrongStore> {};

TEST_P(WrongTexels, AreCaughtUnlessTheyAreTheSame) {
    OtherTexels renderer(GetParam().store);
    const Outcome outcome = outcomeOf(renderer, "internal-formats", 112, "llvmpipe");
    EXPECT_EQ(outcome.verdict(), GetParam().agrees ? Verdict::Agree : Verdict::Differ)
        << outcome.all.over << " pixels over";
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongTexels,
    testing::Values(WrongStore{"TheSame", [](std::array<int, 4>&, const FormatFacts&) {}, true},
                    WrongStore{"TruncatedToFewBits",
                               [](std::array<int, 4>& texel, const FormatFacts& facts) {
                                   for (std::size_t c = 0; c < 4; ++c) {
                                       const int bits = facts.bits.at(c);
                                       if (bits > 0 && bits < 8)
                                           texel.at(c) = byteOf(texel.at(c) * maxNumber(bits) / 255, bits);
                                   }
                               }},
                    WrongStore{"LowestBitsCutOff",
                               [](std::array<int, 4>& texel, const FormatFacts& facts) {
                                   for (std::size_t c = 0; c < 4; ++c) {
                                       const int bits = facts.bits.at(c);
                                       if (bits > 0 && bits < 8)
                                           texel.at(c) = byteOf(texel.at(c) >> (8 - bits), bits);
                                   }
                               }},
                    WrongStore{"AlphaOfSrgbDecoded",
                               [](std::array<int, 4>& texel, const FormatFacts& facts) {
                                   if (facts.encoding == Encoding::Srgb)
                                       texel[3] = lightOf(texel[3]);
                               }}),
    [](const auto& test) { return std::string(test.param.name); });

const Wrong wrongs[] = {
    {"WrapModesSwapped", "wrap",
     [](Scene& s) { eachTexture(s, [](Texture& t) { std::swap(t.wrapS, t.wrapT); }); }},
    {"OneCombinationOfWrapModesWrong", "wrap",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.wrapS == Wrap::MirroredRepeat && t.wrapT == Wrap::ClampToEdge)
                 t.wrapS = Wrap::Repeat;
         });
     },
     nullptr, 100},
    {"BorderColorLost", "wrap", [](Scene& s) { eachTexture(s, [](Texture& t) { t.borderColor = {}; }); }},
    {"ClampAsClampToEdge", "wrap-linear",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) { t.wrapS = t.wrapS == Wrap::Clamp ? Wrap::ClampToEdge : t.wrapS; });
     }},
    {"RoundedDown", "combine", nullptr,
     [](Image& image, const Scene&) {
         for (std::byte& each : image.pixels)
             each = static_cast<std::byte>(std::max(0, std::to_integer<int>(each) - 2));
     }},
    {"ModulateAsReplace", "environment",
     [](Scene& s) {
         eachUnit(s,
                  [](Unit& u) { u.envMode = u.envMode == EnvMode::Modulate ? EnvMode::Replace : u.envMode; });
     }},
    {"IntensityAsLuminance", "environment",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.internalFormat == InternalFormat::Intensity)
                 t.internalFormat = InternalFormat::Luminance;
         });
     },
     nullptr, 144},
    {"FewBitsAsEight", "internal-formats",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (hasFewBits(t.internalFormat))
                 t.internalFormat = internalFormat(baseFormat(t.internalFormat));
         });
     }},
    {"SrgbNotDecoded", "internal-formats",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (isSrgb(t.internalFormat))
                 t.internalFormat = internalFormat(baseFormat(t.internalFormat));
         });
     },
     nullptr, 112},
    {"FloatsLimited", "float-formats",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) { t.internalFormat = internalFormat(baseFormat(t.internalFormat)); });
     }},
    {"SrgbDecodedAfterTheFilter", "internal-formats",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (isSrgb(t.internalFormat))
                 t.internalFormat = internalFormat(baseFormat(t.internalFormat));
         });
     },
     [](Image& image, const Scene& scene) {
         for (std::size_t i = 0; isSrgb(scene.textures[0].internalFormat) && i < image.pixels.size(); ++i) {
             if (i % 4 != 3)
                 image.pixels[i] = static_cast<std::byte>(lightOf(std::to_integer<int>(image.pixels[i])));
         }
     },
     112},
    {"DepthsComparedTheOtherWayRound", "depth-textures",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.compareFunc == CompareFunc::Less)
                 t.compareFunc = CompareFunc::Greater;
             else if (t.compareFunc == CompareFunc::GreaterEqual)
                 t.compareFunc = CompareFunc::LessEqual;
         });
     }},
    // What r beyond 1 gives against a depth of 1 where it isn't clamped, and below 0 against 0.
    {"ComparedWithoutClamping", "depth-textures",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.compareFunc == CompareFunc::LessEqual)
                 t.compareFunc = CompareFunc::Less;
             else if (t.compareFunc == CompareFunc::GreaterEqual)
                 t.compareFunc = CompareFunc::Greater;
         });
     },
     nullptr, 96},
    {"DepthsNotCompared", "depth-textures",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.compareMode = CompareMode::None; }); }},
    {"ComparedButNotFiltered", "depth-textures",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             t.magFilter = MagFilter::Nearest;
             t.minFilter = MinFilter::Nearest;
         });
     }},
    {"DepthModeIgnored", "depth-textures",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.depthMode = DepthMode::Luminance; }); }},
    {"BorderOfDepthsLost", "depth-textures",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.borderColor.r = 1 - t.borderColor.r; }); }, nullptr,
     96},
    {"DepthsAsColors", "depth-textures",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.internalFormat = InternalFormat::Luminance; }); }},
    {"ProjectedWithoutItsAngle", "projector", [](Scene& s) { s.light.projector.fieldOfView *= 1.1F; }},
    {"ProjectedInParallel", "projector", [](Scene& s) { s.light.position.w = 0; }},
    {"ProjectedFromAnotherPlace", "projector", [](Scene& s) { s.light.position.x += 0.1F; }},
    {"ShadowsWithoutBias", "projector", [](Scene& s) { eachStep(s, [](MatrixStep& m) { m.amount.z = 0; }); }},
    {"ShadowsOfOneModelAlone", "projector",
     [](Scene& s) { // what should be in shadow is lit
         if (s.textures[0].source == SourceKind::LightDepth)
             s.textures[0].compareFunc = CompareFunc::Always;
     }},
    {"SubimagesLeftOut", "subimages", [](Scene& s) { s.textures[0].subimages.clear(); }},
    {"SubimageAsIfItFitted", "subimages", [](Scene& s) { s.textures[0].subimages[0].x = 0; }},
    {"PictureOfTheBackground", "pictures", [](Scene& s) { s.passes[0].enabled = false; }},
    {"FramesLeftOut", "pictures", [](Scene& s) { s.textures[1].frames = 1; }},
    {"EnvironmentColorLost", "environment", [](Scene& s) { eachUnit(s, [](Unit& u) { u.envColor = {}; }); }},
    {"OperandInverted", "combine",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             if (u.combine.operand1Rgb == OperandRgb::OneMinusSrcAlpha)
                 u.combine.operand1Rgb = OperandRgb::SrcAlpha;
         });
     }},
    {"CrossbarIgnored", "combine",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             if (u.combine.source0Rgb == CombineSource::Texture0)
                 u.combine.source0Rgb = CombineSource::Texture;
         });
     }},
    {"AlphaScaleIgnored", "combine",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.combine.alphaScale = CombineScale::One; }); }},
    {"LastUnitDropped", "units", [](Scene& s) { s.passes[0].units[s.textures.size() - 1].enabled = false; }},
    {"EyePlanesAsObjectPlanes", "texgen-linear",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             u.texGenS.mode = TexGenMode::ObjectLinear;
             u.texGenS.objectPlane.w += u.texGenS.eyePlane.z;
         });
         s.models[0].position = {};
         eachUnit(s, [](Unit& u) { u.texGenT.enabled = false; });
     }},
    {"SphereMapAsReflection", "texgen-maps",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             if (u.texGenS.mode == TexGenMode::SphereMap)
                 u.texGenS.mode = TexGenMode::ReflectionMap;
         });
     }},
    {"GeneratedQIgnored", "texgen-maps",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.texGenQ.enabled = false; }); }},
    {"NormalMapAsReflection", "texgen-shapes",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             if (u.texGenT.mode == TexGenMode::NormalMap)
                 u.texGenT.mode = TexGenMode::ReflectionMap;
         });
     }},
    {"PivotIgnored", "matrix", [](Scene& s) { eachStep(s, [](MatrixStep& m) { m.pivot = {}; }); }},
    {"LoadAsMultiply", "matrix",
     [](Scene& s) {
         eachStep(s, [](MatrixStep& m) { m.op = m.op == MatrixOp::Load ? MatrixOp::Multiply : m.op; });
     },
     nullptr, 100},
    {"MatrixTransposed", "matrix",
     [](Scene& s) { eachStep(s, [](MatrixStep& m) { std::swap(m.matrix[0].y, m.matrix[1].x); }); }},
    {"MatrixBackwards", "matrix",
     [](Scene& s) { eachUnit(s, [](Unit& u) { std::ranges::reverse(u.matrix); }); }},
    {"MatricesOfModelsIgnored", "matrix-stack",
     [](Scene& s) { eachModel(s, [](Model& m) { m.units = {}; }); }},
    {"MatricesOfModelsNeverPopped", "matrix-stack",
     [](Scene& s) { eachModel(s, [](Model& m) { m.pushMatrix = false; }); }},
    {"MatricesAlwaysBegun", "matrix-stack",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.matrixStart = MatrixStart::Identity; }); }},
    {"MatricesKeptInsteadOfPushed", "matrix-stack",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             if (u.matrixStart == MatrixStart::Push)
                 u.matrixStart = MatrixStart::Keep;
         });
     }},
    {"TexelsBesideByASixteenth", "nearest",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             u.matrix = {{.op = MatrixOp::Translate, .amount = {1.0F / 1024, 0, 0}}};
         });
     }},
    {"LinearAsNearest", "linear",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.minFilter = MinFilter::Nearest; }); }},
    {"FiltersSwapped", "magnification",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             const bool linear = t.magFilter == MagFilter::Linear;
             t.magFilter = linear ? MagFilter::Nearest : MagFilter::Linear;
             t.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
         });
     }},
    {"LevelsRoundedDown", "mipmap-nearest",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.lodBias -= 0.5F; }); }},
    {"LambdaOffByATenth", "trilinear", [](Scene& s) { eachUnit(s, [](Unit& u) { u.lodBias += 0.1F; }); }},
    {"BiasIgnored", "lod", [](Scene& s) { eachUnit(s, [](Unit& u) { u.lodBias = 0; }); }},
    {"BiasOfTheTextureIgnored", "lod", [](Scene& s) { eachTexture(s, [](Texture& t) { t.lodBias = 0; }); }},
    {"MinLodIgnored", "lod-trilinear",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.minLod = -1000; }); }},
    {"MaxLodIgnored", "lod-trilinear", [](Scene& s) { eachTexture(s, [](Texture& t) { t.maxLod = 1000; }); }},
    {"BaseLevelIgnored", "lod", [](Scene& s) { eachTexture(s, [](Texture& t) { t.baseLevel = 0; }); }},
    {"MaxLevelIgnored", "lod", [](Scene& s) { eachTexture(s, [](Texture& t) { t.maxLevel = 1000; }); }},
    {"MissingLevelsMade", "levels",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.mipmaps == MipPolicy::Missing)
                 t.mipmaps = MipPolicy::Generated;
         });
     }},
    {"LastLevelBeforeTheFirstTaken", "levels",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.maxLevel = std::max(t.maxLevel, t.baseLevel); }); }},
    {"LevelsOfFilesMade", "levels",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.mipmaps == MipPolicy::FromFile)
                 t.mipmaps = MipPolicy::Generated;
         });
     }},
    {"SeamlessIgnored", "seamless",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.seamlessCubeMap = false;
         for (Texture& texture : s.textures) // as llvmpipe does where it is off
             texture.wrapS = texture.wrapT = Wrap::ClampToEdge;
     },
     nullptr, 8},
    {"SeamlessOfTheSameFace", "seamless",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.seamlessCubeMap = false;
         for (Texture& texture : s.textures)
             texture.wrapS = texture.wrapT = Wrap::Repeat;
     },
     nullptr, 8},
    {"CubesClampedToTheEdge", "cube-map",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.wrapS == Wrap::ClampToBorder || t.wrapS == Wrap::Clamp)
                 t.wrapS = Wrap::ClampToEdge;
         });
     },
     nullptr, 64, "a driver that wraps them"},
    {"AnisotropyIgnored", "anisotropy",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.maxAnisotropy = 1; }); }, nullptr, 400},
    {"VolumesAsPictures", "targets",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.texGenR.enabled = false; }); }},
    {"NormalsAsReflections", "cube-map",
     [](Scene& s) {
         eachUnit(s, [](Unit& u) {
             u.texGenR.mode =
                 u.texGenR.mode == TexGenMode::NormalMap ? TexGenMode::ReflectionMap : u.texGenR.mode;
         });
     }},
    {"BorderStripped", "border", [](Scene& s) { eachTexture(s, [](Texture& t) { t.border = 0; }); }},
    {"HintIgnored", "hint", [](Scene& s) { s.view.perspectiveHint = HintMode::Nicest; }},
    {"CompressionIgnored", "compression",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.compression = Compression::None; }); }},
    {"IncompleteDrawnAnyway", "incomplete",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.mipmaps = MipPolicy::Generated; }); }},
    {"GivenLevelsMade", "given-levels",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.mipmaps = MipPolicy::Generated; }); }, nullptr, 8},
    {"GivenLevelsOneOff", "given-levels",
     [](Scene& s) { eachTexture(s, [](Texture& t) { std::ranges::rotate(t.levels, t.levels.end() - 1); }); },
     nullptr, 8},
    {"LevelsOfAnotherSizeFitted", "given-levels",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             for (GivenLevel& level : t.levels)
                 level.source = SourceKind::Pattern;
         });
     },
     nullptr, 96},
    {"MissingGivenLevelsMade", "given-levels",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.maxLevel == 1000)
                 t.levels.resize(8);
         });
     },
     nullptr, 16},
    {"PreparationIgnored", "preparation",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.preparation.clear(); }); }},
    {"PreparedBackwards", "preparation",
     [](Scene& s) { eachTexture(s, [](Texture& t) { std::ranges::reverse(t.preparation); }); }, nullptr, 132},
    {"PreparedByTheFirstStepAlone", "preparation",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.preparation.resize(1); }); }, nullptr, 132},
    {"ImageBiasIgnored", "preparation",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             for (ImageStep& step : t.preparation)
                 step.bias = glm::vec4(0);
         });
     }},
    {"NotSharpened", "preparation",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             for (ImageStep& step : t.preparation)
                 step.amount = 0;
         });
     }},
    {"UploadIgnored", "upload", [](Scene& s) { eachTexture(s, [](Texture& t) { t.upload = {}; }); }},
    {"RowsNeverAligned", "upload",
     [](Scene& s) { eachTexture(s, [](Texture& t) { t.upload.alignment = 1; }); }, nullptr, 132},
    {"BlueReadAsRed", "upload",
     [](Scene& s) {
         eachTexture(s, [](Texture& t) {
             if (t.upload.format == TransferFormat::Bgr)
                 t.upload.format = TransferFormat::Rgb;
         });
     },
     nullptr, 132},
    {"AlphaTestBackwards", "alpha-test",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             if (pass.alphaFunc == CompareFunc::GreaterEqual)
                 pass.alphaFunc = CompareFunc::LessEqual;
     }},
    {"BlendFactorsSwapped", "blend",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             if (pass.blendSrc == BlendFactor::DstAlpha)
                 pass.blendSrc = BlendFactor::OneMinusDstAlpha;
     }},
    {"PassesThatAreOffDrawn", "passes",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.enabled = true;
     }},
    {"LastPassDropped", "passes", [](Scene& s) { s.passes.pop_back(); }},
    {"NamedModelsIgnored", "passes",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.models.clear();
     }},
    {"NamedModelsInTheScenesOrder", "passes",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             std::ranges::sort(pass.models);
     }},
    {"DepthFunctionIgnored", "depth",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             if (pass.depthFunc == CompareFunc::Greater)
                 pass.depthFunc = CompareFunc::Less;
     }},
    {"FlatAsSmooth", "lighting", [](Scene& s) { s.material.shadeModel = ShadeModel::Smooth; }},
    {"ViewerNotLocal", "lighting", [](Scene& s) { s.light.localViewer = false; }},
    {"HighlightUnderTheTexture", "specular", [](Scene& s) { s.light.colorControl = ColorControl::Single; }},
    {"TwoSidesIgnored", "two-sided", [](Scene& s) { s.light.twoSide = false; }},
    {"BackLitByAnInfiniteViewer", "two-sided", [](Scene& s) { s.light.localViewer = false; }},
    {"BackFlatAsSmooth", "two-sided", [](Scene& s) { s.material.shadeModel = ShadeModel::Smooth; }},
    {"FogIgnored", "fog",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.fog.enabled = false;
     }},
    {"FogAsItsSquare", "fog",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.fog.mode = pass.fog.mode == FogMode::Exp ? FogMode::Exp2 : pass.fog.mode;
     }},
    {"FogTooFarAway", "fog",
     [](Scene& s) {
         for (Pass& pass : s.passes) {
             pass.fog.start += 0.1F;
             pass.fog.end += 0.1F;
         }
     }},
    {"FogTooDark", "fog",
     [](Scene& s) {
         for (Pass& pass : s.passes)
             pass.fog.color = pass.fog.color * 0.95F;
     }},
    {"APixelTooFarRight", "coverage", [](Scene& s) { s.models[0].position.x += 0.02F; }},
    {"LineWidthIgnored", "lines", [](Scene& s) { eachModel(s, [](Model& m) { m.lineWidth = 1; }); }},
    {"PointSizeIgnored", "lines", [](Scene& s) { eachModel(s, [](Model& m) { m.pointSize = 1; }); }},
    {"LoopsLeftOpen", "lines",
     [](Scene& s) {
         eachModel(s, [](Model& m) {
             if (m.mesh.primitive == Primitive::LineLoop)
                 m.mesh.primitive = Primitive::LineStrip;
         });
     },
     nullptr, 120},
    {"ColorsOfLinesIgnored", "lines",
     [](Scene& s) { eachModel(s, [](Model& m) { m.mesh.colors.clear(); }); }},
    {"FlatLinesAsSmooth", "lines", [](Scene& s) { s.material.shadeModel = ShadeModel::Smooth; }},
    {"TexturesOfLinesIgnored", "lines", [](Scene& s) { eachUnit(s, [](Unit& u) { u.enabled = false; }); }},
    {"LeftOutTexCoordsSent", "lines", [](Scene& s) { eachModel(s, [](Model& m) { m.noTexCoord = {}; }); }},
    {"ColorsOfVerticesIgnored", "meshes",
     [](Scene& s) { eachModel(s, [](Model& m) { m.mesh.colors.clear(); }); }},
    {"NormalsIgnored", "meshes", [](Scene& s) { eachModel(s, [](Model& m) { m.mesh.normals.clear(); }); }},
    {"IndicesIgnored", "meshes", [](Scene& s) { eachModel(s, [](Model& m) { m.mesh.indices.clear(); }); }},
    {"QuadsAsStrips", "meshes",
     [](Scene& s) {
         eachModel(s, [](Model& m) {
             if (m.mesh.primitive == Primitive::Quads)
                 m.mesh.primitive = Primitive::QuadStrip;
         });
     }},
    {"HolesFilled", "quadrics", [](Scene& s) { eachModel(s, [](Model& m) { m.innerRadius = 0; }); }},
    {"ConesAsCylinders", "quadrics", [](Scene& s) { eachModel(s, [](Model& m) { m.topRadius = 1; }); }},
    {"SweptTheOtherWay", "quadrics",
     [](Scene& s) { eachModel(s, [](Model& m) { m.sweepAngle = -m.sweepAngle; }); }},
    {"TubesTooThin", "quadrics", [](Scene& s) { eachModel(s, [](Model& m) { m.tubeRadius *= 0.9F; }); }},
    {"TeapotsTooCoarse", "quadrics",
     [](Scene& s) {
         eachModel(s, [](Model& m) {
             if (m.shape == Shape::Teapot)
                 m.stacks = minStacks;
         });
     }},
    {"EmissionIgnored", "materials",
     [](Scene& s) {
         s.material.emission = {};
         eachModel(s, [](Model& m) { m.material.emission = {}; });
     }},
    {"OwnMaterialIgnored", "materials",
     [](Scene& s) { eachModel(s, [](Model& m) { m.ownMaterial = false; }); }},
    {"ColorMaterialAlwaysOn", "materials", [](Scene& s) { s.material.colorMaterial = true; }},
    {"AmbientAsDiffuse", "materials", [](Scene& s) { s.material.ambient = s.material.diffuse; }},
    {"ScaleIgnored", "placement", [](Scene& s) { eachModel(s, [](Model& m) { m.scale = glm::vec3(1); }); }},
    {"RotationOrderIgnored", "placement",
     [](Scene& s) { eachModel(s, [](Model& m) { m.rotationOrder = RotationOrder::Zyx; }); }},
    {"AttachmentIgnored", "placement",
     [](Scene& s) { eachModel(s, [](Model& m) { m.attachment = Attachment::World; }); }},
    {"RollIgnored", "placement", [](Scene& s) { s.view.roll = 0; }},
    {"EmbossIgnored", "emboss", [](Scene& s) { eachUnit(s, [](Unit& u) { u.emboss.enabled = false; }); }},
    {"LightAlwaysByTheInverse", "emboss",
     [](Scene& s) { eachUnit(s, [](Unit& u) { u.emboss.carrier = LightCarrier::Inverse; }); }},
    {"LightAlwaysAtInfinity", "emboss", [](Scene& s) { s.light.position.w = 0; }},
    {"SecondUnitAsFirst", "mixture", [](Scene& s) { eachUnit(s, [](Unit& u) { u.texture = 0; }); }},
};

INSTANTIATE_TEST_SUITE_P(All, WrongRenderer, testing::ValuesIn(wrongs),
                         [](const auto& test) { return std::string(test.param.name); });

// Every feature has a renderer that is wrong about it.
TEST(WrongRenderers, ThereIsOneForEachFeature) {
    for (const Feature& feature : features())
        EXPECT_TRUE(std::ranges::any_of(wrongs, [&](const Wrong& wrong) {
            return wrong.feature == feature.name;
        })) << feature.name;
}

} // namespace
} // namespace texplorer::conform::sweep_test

#include "tests/random/trial.h"

#include "app/offscreen/context.h"
#include "app/render/scene_renderer.h"
#include "app/render/shader_renderer.h"
#include "app/view/driver_facts.h"
#include "tests/random/random_skip.h"
#include "texplorer/conform/feature.h"
#include "texplorer/conform/judge.h"
#include "texplorer/reference/contributions.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

namespace texplorer::random {

namespace {

using conform::extent;

std::string nameOf(RendererKind kind) {
    return std::string(rowOf(kind).name);
}

/// The tolerance for a random scene: the rule for a mixture of all features, with two differences. Each
/// further pass adds one 255th, because the next pass reads its rounded result. And 3 % of a picture may stay
/// unexplained: the judge gives all units the same error of lambda, while their errors differ.
conform::Rule ruleFor(const Scene& scene, const conform::Pair& pair) {
    conform::Rule rule = conform::rules::lastBit;
    if (pair.has(RendererKind::Reference)) {
        const bool foreign =
            std::ranges::find(scene.textures, MipPolicy::Given, &Texture::mipmaps) != scene.textures.end();
        rule = foreign ? conform::rules::foreignLevels : conform::rules::levelBlend;
        rule.explainedScene = 0.97;
    }
    rule.bound += static_cast<int>(scene.passes.size()) - 1;
    return rule;
}

/// Whether a position is beyond the range of a float: the result is then undefined (OpenGL 2.1, section
/// 2.1.1).
bool overflows(const reference::Explanation& pixel) {
    const auto isFinite = [](const glm::vec4& each) {
        return std::isfinite(each.x) && std::isfinite(each.y) && std::isfinite(each.z) &&
               std::isfinite(each.w);
    };
    return std::ranges::any_of(pixel.fragments, [&](const reference::FragmentExplanation& fragment) {
        return std::ranges::any_of(fragment.vertices, [&](const reference::VertexExplanation& vertex) {
            return !isFinite(vertex.eye) || !isFinite(vertex.clip);
        });
    });
}

/// Whether the reference explains the colour of a pixel: its own colour, or one that a tie allows. Each
/// fragment that is blended over another rounds, and multiplies the earlier rounding error by both of its
/// factors.
bool isExplained(const reference::Explanation& pixel, ByteView found, int bound) {
    const auto blended = std::ranges::count_if(pixel.fragments, [](const auto& fragment) {
        return fragment.blend.enabled && fragment.outcome == reference::FragmentOutcome::Drawn;
    });
    const long allowed = bound + 3 * blended;
    const auto isNear = [&](const reference::PixelBytes& right) {
        for (std::size_t c = 0; c < 4; ++c) {
            if (std::abs(right[c] - std::to_integer<int>(found[c])) > allowed)
                return false;
        }
        return true;
    };
    return isNear(pixel.bytes) || std::ranges::any_of(pixel.asRight, isNear);
}

bool isOneSentence(std::string_view text) {
    return !text.empty() &&
           std::ranges::none_of(text, [](char each) { return static_cast<unsigned char>(each) < 0x20; });
}

} // namespace

struct Trial::State {
    Precision precision;
    std::filesystem::path files;
    offscreen::Context context;
    view::Capabilities capabilities;
    std::map<RendererKind, render::SceneRenderer> renderers{}; // destroyed before its context

    struct Run;
};

/// The state of one scene's trial.
struct Trial::State::Run {
    State& state;
    const RandomScene& random;
    Journal& journal;
    ImageSource images{state.files};
    std::vector<Finding> findings{}; ///< on this driver
    std::map<RendererKind, Image> pictures{};

    const Scene& scene() const { return random.scene; }
    void broken(const std::string& what) { journal.note("broken", what); }
    void heed(const std::vector<Sentence>& problems) {
        for (const Sentence& each : problems) {
            if (!isOneSentence(each))
                broken("a problem isn't one sentence: " + each.english());
        }
    }

    void writeAndRead() {
        journal.step("json");
        const Result<Scene> read = parseScene(writeScene(scene()));
        if (!read)
            broken("can't be read as it was written: " + describe(read.error()).english());
        else if (*read != scene())
            broken("written and read it is another scene");
    }

    void load() {
        journal.step("load");
        if (const Result<void> loaded = images.load(scene()); !loaded)
            heed({describe(loaded.error())});
    }

    void check() {
        journal.step("check");
        for (const DriverFacts& facts : {DriverFacts{}, view::driverFacts(state.capabilities)}) {
            findings = diagnose(scene(), images, facts);
            for (const Finding& each : findings) {
                if (!isOneSentence(each.sentence))
                    broken("a finding isn't one sentence: " + each.sentence.english());
                for (const Fix& fix : each.fixes) {
                    Scene fixed = scene();
                    if (const Result<void> applied = apply(fix, fixed); !applied)
                        broken("can't be fixed as " + std::string(each.rule) +
                               " says: " + describe(applied.error()).english());
                }
            }
        }
    }

    void draw(RendererKind kind) {
        journal.step(nameOf(kind));
        render::SceneRenderer& renderer = state.renderers.at(kind);
        const Result<view::Frame> frame = renderer.draw(scene(), images, 0, {extent, extent});
        Result<Image> image = frame ? renderer.read() : fail(frame.error());
        if (!image)
            return broken(nameOf(kind) + ": " + describe(image.error()).english());
        heed(frame->problems);
        for (const auto& [key, picture] : frame->pictures) // the same for all, so that the window is compared
            images.putPicture(key, picture);
        pictures.emplace(kind, std::move(*image));
    }

    [[nodiscard]] reference::DrawRequest request() const {
        return {
            scene(), images,
            0,       extent,
            extent,  reference::anisotropyMethodOf(state.capabilities.renderer, state.capabilities.version)};
    }

    void drawReference() {
        journal.step("reference");
        Result<Frame> drawn = reference::drawReference(request(), {.threads = 1});
        if (!drawn)
            return broken("reference: " + describe(drawn.error()).english());
        heed(drawn->problems);
        if (std::ranges::equal(std::span(drawn->image.pixels).subspan(4),
                               std::span(drawn->image.pixels).first(drawn->image.pixels.size() - 4)))
            journal.note("blank", "");
        pictures.emplace(RendererKind::Reference, std::move(drawn->image));
    }

    /// The explained colour must be the drawn one.
    void probe() {
        journal.step("probe");
        const auto drawn = pictures.find(RendererKind::Reference);
        for (const reference::PixelPlace place :
             {reference::PixelPlace{0, 0}, {extent / 2, extent / 2}, {extent / 3, extent - 9}}) {
            const Result<reference::Explanation> explained =
                reference::probe(request(), place, {.threads = 1});
            if (!explained) {
                broken("probe: " + describe(explained.error()).english());
                continue;
            }
            const auto isByte = [](std::uint8_t found, std::byte expected) {
                return found == std::to_integer<std::uint8_t>(expected);
            };
            if (drawn != pictures.end() && !overflows(*explained) &&
                !std::ranges::equal(explained->bytes, drawn->second.at(place.x, place.y).first(4), isByte))
                broken("probe: another colour than the reference's at " + std::to_string(place.x) + "," +
                       std::to_string(extent - 1 - place.y));
        }
    }

    void findTexel() {
        journal.step("texel");
        for (std::size_t p = 0; p < scene().passes.size(); ++p) {
            for (std::size_t u = 0; u < maxUnits; ++u) {
                const Unit& unit = scene().passes[p].units[u];
                if (!unit.enabled)
                    continue;
                const int level = scene().textures[static_cast<std::size_t>(unit.texture)].baseLevel;
                const Result<reference::Contributions> found = reference::contributions(
                    {scene(), images, 0, extent, extent},
                    {static_cast<int>(p), static_cast<int>(u), {level, {0, 0, 0}}}, {.threads = 1});
                if (!found && found.error().code != ErrorCode::OutOfRange &&
                    found.error().code != ErrorCode::Unsupported)
                    broken("texel: " + describe(found.error()).english());
                return; // one is enough
            }
        }
    }

    /// Whether no more than the allowed number of pixels differ by more than the bound without an explanation
    /// of both colours by the reference.
    [[nodiscard]] bool areExplained(const conform::Pair& pair, int bound, std::size_t allowed) const {
        const Image& subject = pictures.at(pair.subject);
        const Image& against = pictures.at(pair.against);
        std::size_t count = 0;
        for (int y = 0; y < extent; ++y) {
            for (int x = 0; x < extent; ++x) {
                const std::array found{subject.at(x, y).first(4), against.at(x, y).first(4)};
                bool differs = false;
                for (std::size_t c = 0; c < 4; ++c)
                    differs |= std::abs(std::to_integer<int>(found[0][c]) -
                                        std::to_integer<int>(found[1][c])) > bound;
                if (!differs)
                    continue;
                const auto explained = reference::probe(request(), {x, y}, {.threads = 1});
                const bool isRight = explained && std::ranges::all_of(found, [&](ByteView each) {
                                         return isExplained(*explained, each, bound);
                                     });
                if (!isRight && ++count > allowed)
                    return false; // a probe of a heavy scene takes long
            }
        }
        return true;
    }

    void compare(const conform::Pair& pair, const conform::Driver& driver) {
        if (!pictures.contains(pair.subject) || !pictures.contains(pair.against))
            return; // was reported
        const std::string name = nameOf(pair.subject) + "-" + nameOf(pair.against);
        journal.step("compare " + name);
        const RandomScene standing{random.temper, *StandingScene(scene(), 0)}; // with what key frames set
        if (const Skipped skipped = skipOf({standing, findings, pair, driver}); !skipped.name.empty())
            return journal.note("skip", name + ": " + std::string(skipped.name));
        const conform::Rule rule = ruleFor(scene(), pair);
        const std::unique_ptr<conform::Explainer> reference = conform::referenceRendererWith(images, driver);
        const Result<conform::Judgement> judgement =
            conform::judge(rule, scene(), pictures.at(pair.subject), pictures.at(pair.against), *reference);
        if (!judgement)
            return broken("compare: " + describe(judgement.error()).english());
        const double wrong =
            static_cast<double>(judgement->unexplained) / static_cast<double>(judgement->difference.pixels);
        const auto allowed =
            static_cast<std::size_t>((1 - rule.explainedScene) * static_cast<double>(extent * extent));
        if (wrong <= 1 - rule.explainedScene || areExplained(pair, rule.bound, allowed))
            return journal.note("agree", name);
        journal.note("differ", name + ": " + std::to_string(judgement->unexplained) + " of " +
                                   std::to_string(judgement->difference.pixels) + " pixels by more than " +
                                   std::to_string(rule.bound) + ", at worst " +
                                   std::to_string(judgement->difference.max));
    }
};

Trial::Trial(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Trial::Trial(Trial&&) noexcept = default;
Trial& Trial::operator=(Trial&&) noexcept = default;
Trial::~Trial() = default;

Result<Trial> Trial::open(Precision precision, const std::filesystem::path& files,
                          const std::filesystem::path& shaders) {
    if (precision == Precision::Exact) {
        ::setenv("GALLIVM_PERF", "no_rho_approx,no_brilinear,no_quad_lod,no_aos_sampling", 1);
        ::setenv("LP_NUM_THREADS", "0", 1); // a picture is one tile
    }
    Result<offscreen::Context> context = offscreen::Context::create({1, 1});
    if (!context)
        return fail(context.error());
    const Result<view::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    auto state = std::make_unique<State>(State{precision, files, std::move(*context), *capabilities});
    for (const RendererKind kind : {RendererKind::Fixed, RendererKind::Shader}) {
        Result<render::SceneRenderer> renderer = render::createRenderer(kind, *capabilities, {shaders, {}});
        if (!renderer)
            return fail(renderer.error());
        state->renderers.emplace(kind, std::move(*renderer));
    }
    return Trial(std::move(state));
}

void Trial::run(const RandomScene& random, Journal& journal) {
    const conform::Driver driver{state_->capabilities.renderer,
                                 state_->capabilities.version,
                                 {},
                                 view::driverFacts(state_->capabilities)};
    State::Run run{*state_, random, journal};
    run.writeAndRead();
    run.load();
    run.check();
    run.draw(RendererKind::Fixed);
    run.draw(RendererKind::Shader);
    run.drawReference();
    run.probe();
    run.findTexel();
    if (state_->precision == Precision::Usual)
        return;
    for (const conform::Pair& pair : conform::defaultPairs)
        run.compare(pair, driver);
}

} // namespace texplorer::random

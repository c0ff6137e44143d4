#include "app/ui/model/explaining.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/inset_placement.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/drawn_texts.h"
#include "tests/ui/workbench.h"
#include "texplorer/reference/probe.h"

#include <fmt/core.h>
#include <imgui_internal.h> // which windows scroll

#include <atomic>
#include <mutex>
#include <tuple>

namespace texplorer::ui::explain_tab_test {
namespace {

using namespace test;

class ExplainTab : public Workbench {
protected:
    void open() {
        session->window.wantedTab = Tab::Explain;
        frames(3);
    }
    /// In the narrow dock, where there is a list in the place of the cards.
    void openList() {
        moveTab(session->settings.workspace, Tab::Explain, Dock::Right);
        frames(3);
    }
    void close() {
        closeTab(session->settings.workspace, Tab::Explain);
        frames(3);
    }
    /// A place in the view where the cube is.
    [[nodiscard]] ImVec2 onTheCube() const {
        return {static_cast<float>(layout.picture.x) + static_cast<float>(layout.picture.width) * 0.3F,
                static_cast<float>(layout.picture.y) + static_cast<float>(layout.picture.height) * 0.5F};
    }
    void explainTheCube() {
        open();
        clickAt(onTheCube());
    }
    /// The middle of a texel of the first small picture.
    ImVec2 inPatch() {
        return place("patch:level " + std::to_string(probedUnit(*session)->patches.front().level));
    }
    [[nodiscard]] Explaining& explaining() { return session->look.explaining; }
    [[nodiscard]] Box boxOf(std::string_view name) const {
        const WidgetPlaces::Item& item = places.items.find(name)->second;
        return {{item.left, item.top}, {item.right, item.bottom}};
    }
    /// The items whose names begin so.
    [[nodiscard]] std::vector<std::string> itemsOf(std::string_view beginning) const {
        std::vector<std::string> names;
        for (const auto& [name, item] : places.items)
            if (name.starts_with(beginning))
                names.push_back(name);
        return names;
    }
    /// With a picture by the fixed pipeline that has these bytes at the pixel.
    [[nodiscard]] Comparison comparedWith(const reference::PixelBytes& bytes,
                                          const reference::Explanation& explanation) const {
        Image image = Image::uninitialised(PixelFormat::Rgba8, explanation.width, explanation.height);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            image.at(explanation.pixel.x, explanation.pixel.y)[i] = std::byte{bytes[i]};
        const std::vector<ViewFrame> views{
            {RendererKind::Fixed, {}, std::make_shared<const Image>(std::move(image)), true}};
        return compareRenderers(*session, {.frames = views}, explanation);
    }
    /// Expects a card to be visible, and within the dock.
    void expectInTheDock(const std::string& name) {
        ASSERT_TRUE(has(name)) << name;
        const WidgetPlaces::Item& card = places.items.at(name);
        EXPECT_TRUE(card.visible) << name;
        EXPECT_GE(card.left, static_cast<float>(layout.belowDock.x)) << name;
        EXPECT_LE(card.right, static_cast<float>(layout.belowDock.right())) << name;
        EXPECT_LE(card.bottom, static_cast<float>(layout.belowDock.bottom())) << name;
    }
};

TEST_F(ExplainTab, SaysWhatToDoFirst) {
    open();
    EXPECT_TRUE(has("explain:none"));
    EXPECT_FALSE(has("explained pixel"));
}

TEST_F(ExplainTab, AClickChoosesThePixelBelowIt) {
    explainTheCube();
    ASSERT_TRUE(explaining().pixel);
    const Panes panes(layout, session->view, {layout.picture.width, layout.picture.height});
    const auto expected = panes.pixelAt(onTheCube());
    EXPECT_EQ(*explaining().pixel, (reference::PixelPlace{expected->x, expected->y}));
    const reference::Explanation* found = explanationOf(*session);
    ASSERT_NE(found, nullptr);
    const auto alone = reference::probe(
        {session->document.scene, session->document.images, 0, layout.picture.width, layout.picture.height},
        *explaining().pixel);
    EXPECT_EQ(found->bytes, alone->bytes);
    EXPECT_NE(found->seen(), nullptr);
    EXPECT_TRUE(has("explain:pixel"));
    EXPECT_TRUE(has("card:Texels"));
    EXPECT_TRUE(has("explained pixel"));
}

TEST_F(ExplainTab, ACardSaysWhyAUnitDoesNothing) {
    texture().internalFormat = InternalFormat::Bgr;
    explainTheCube();
    frames(2);
    std::string all;
    for (const std::string& line : drawnTexts())
        all += line + " ";
    EXPECT_THAT(all,
                testing::AllOf(testing::HasSubstr("GL_INVALID_VALUE"), testing::HasSubstr("drawn without")));
    EXPECT_TRUE(has("card:Without effect"));
}

TEST_F(ExplainTab, TheExplainedPixelShowsTheSameInViewsOfOtherShapes) {
    explainTheCube();
    frames(2);
    const auto coords = [this] {
        const reference::UnitExplanation* unit = probedUnit(*session);
        return unit ? glm::vec2(unit->coords) : glm::vec2(-1); // none
    };
    const reference::PixelPlace before = *explaining().pixel;
    const glm::vec2 found = coords();
    ASSERT_GE(found.x, 0);
    const float distance = scene().view.distance;
    const auto expectSame = [&] {
        frames(3);
        EXPECT_NE(scene().view.distance, distance) << "the camera follows the shape";
        EXPECT_NEAR(coords().x, found.x, 0.02F);
        EXPECT_NEAR(coords().y, found.y, 0.02F);
    };
    session->settings.workspace.maximised = Maximised::View;
    expectSame();
    session->settings.workspace.maximised = Maximised::None;
    frames(3);
    EXPECT_EQ(explaining().pixel, before);
    resize(900, 800);
    expectSame();
}

TEST_F(ExplainTab, LetsTheTexturesGoWithThePixel) {
    open();
    const std::shared_ptr<const TextureImage> image =
        session->document.images.find(session->document.scene.textures[0]);
    const long before = image.use_count();
    clickAt(onTheCube());
    ASSERT_TRUE(explaining().pixel);
    EXPECT_EQ(image.use_count(), before + 1);
    explaining().pixel.reset();
    frames(1);
    EXPECT_EQ(image.use_count(), before);
}

TEST_F(ExplainTab, AClickMeansNothingWhileItIsClosed) {
    close();
    clickAt(onTheCube());
    EXPECT_FALSE(explaining().pixel);
}

TEST_F(ExplainTab, EHeldFollowsTheMouseAndBringsTheTab) {
    close();
    moveTo(onTheCube());
    setHeld('E', true);
    frames(3);
    EXPECT_TRUE(explaining().isOpen);
    const auto first = explaining().pixel;
    ASSERT_TRUE(first);
    moveTo({onTheCube().x + 7, onTheCube().y - 5});
    setHeld('E', false);
    frames(2);
    EXPECT_EQ(*explaining().pixel, (reference::PixelPlace{first->x + 7, first->y + 5}));
    moveTo(onTheCube());
    EXPECT_EQ(*explaining().pixel, (reference::PixelPlace{first->x + 7, first->y + 5})) << "it stays";
}

TEST_F(ExplainTab, TellsThatNothingCoversAPixel) {
    open();
    clickAt({static_cast<float>(layout.picture.x + 40), static_cast<float>(layout.picture.y + 60)});
    ASSERT_NE(explanationOf(*session), nullptr);
    EXPECT_TRUE(explanationOf(*session)->fragments.empty());
    EXPECT_FALSE(has("explain:fragment 0"));
}

TEST_F(ExplainTab, FollowsTheScene) {
    explainTheCube();
    const reference::PixelBytes before = explanationOf(*session)->bytes;
    session->document.scene.material.color = {1, 0, 0, 1};
    session->document.scene.passes[0].units[0].enabled = false;
    frames(2);
    EXPECT_NE(explanationOf(*session)->bytes, before);
    EXPECT_TRUE(has("card:Vertices"));
    EXPECT_FALSE(has("card:Texels"));
    EXPECT_EQ(probedUnit(*session), nullptr);
}

TEST_F(ExplainTab, ComparesWithNoPictureThatTheAnswerIsNotOf) {
    std::mutex held; // keeps the worker from what is asked next
    std::atomic<int> answers = 0;
    reference::ProbeWorker worker(reference::ProbeWorker::When::WhenReady, [&] {
        ++answers;
        answers.notify_all();
        const std::scoped_lock lock(held);
    });
    const Services& atOnce = session->services;
    lend({atOnce.files, atOnce.levels, atOnce.reference, atOnce.kept, worker, atOnce.levelMap,
          atOnce.patterns, atOnce.levelPictures, atOnce.lessons, atOnce.environments, atOnce.plainProbe,
          atOnce.sheet, atOnce.programs, atOnce.writing});
    explainTheCube();
    worker.wait();
    (void)picture();
    ASSERT_NE(explanationOf(*session), nullptr);
    const std::string compared = "explain:compared " + std::string(rowOf(RendererKind::Fixed).label);
    EXPECT_TRUE(has(compared));
    std::unique_lock hold(held);
    const int before = answers;
    session->document.scene.view.azimuth += 10;
    (void)picture(); // asks, and the worker stops when it has answered
    answers.wait(before);
    session->document.scene.view.azimuth += 10;
    (void)picture(); // asks, and has an answer about the view before
    EXPECT_NE(explanationOf(*session), nullptr);
    EXPECT_FALSE(has(compared));
    hold.unlock();
    worker.wait();
    (void)picture();
    EXPECT_TRUE(has(compared));
}

TEST_F(ExplainTab, StepsUnfold) {
    openList();
    clickAt(onTheCube());
    EXPECT_FALSE(has("explain:rows of Primary colour"));
    click("explain:Primary colour");
    (void)picture();
    EXPECT_TRUE(has("explain:rows of Primary colour"));
}

// A summary that is longer than the column goes on below.
TEST_F(ExplainTab, NothingIsCutInANarrowColumn) {
    start(defaultScene(), 900, 600);
    openList();
    clickAt({static_cast<float>(layout.picture.x) + static_cast<float>(layout.picture.width) * 0.2F,
             static_cast<float>(layout.picture.y) + static_cast<float>(layout.picture.height) * 0.5F});
    ASSERT_TRUE(has("explain:summary of Level of detail"));
    const std::vector<std::string> summaries = itemsOf("explain:summary of");
    for (const std::string& name : summaries)
        EXPECT_LE(boxOf(name).high.x, static_cast<float>(layout.rightDock.right())) << name;
    EXPECT_GT(summaries.size(), 4U);
}

TEST_F(ExplainTab, ShowsThePixelsThatATexelLights) {
    explainTheCube();
    const reference::UnitExplanation* unit = probedUnit(*session);
    ASSERT_NE(unit, nullptr);
    const int level = unit->patches.front().level;
    clickAt(inPatch());
    ASSERT_TRUE(explaining().texel);
    EXPECT_EQ(explaining().texel->texel.level, level);
    EXPECT_TRUE(has("explain:texel"));
    ASSERT_TRUE(explaining().light);
    EXPECT_EQ(explaining().light->width, layout.picture.width);
    const auto& found = *explaining().answer->contributions;
    ASSERT_TRUE(found);
    clickAt(inPatch()); // once more: no longer
    EXPECT_FALSE(explaining().texel);
    EXPECT_FALSE(explaining().light);
}

TEST_F(ExplainTab, AClickOnTheImageAsksForItsTexel) {
    open();
    // The middle of texel 60, 50 of 64 x 64, where no vertex is.
    const auto at = [&](float s, float t) {
        const ImVec2 low = place("coord:0");
        const ImVec2 high = place("coord:2");
        return ImVec2(low.x + (high.x - low.x) * s, low.y + (high.y - low.y) * t);
    };
    clickAt(at(60.5F / 64, 50.5F / 64));
    ASSERT_TRUE(explaining().texel);
    EXPECT_EQ(explaining().texel->texel, (reference::TexelPlace{0, {60, 50, 0}}));
    EXPECT_TRUE(explaining().light);
    close();
    clickAt(at(20.5F / 64, 20.5F / 64));
    EXPECT_EQ(explaining().texel->texel.index.x, 60) << "only while the tab is open";
}

// Level 6 of 64 x 64 has one row: below it lies the border, which wrapping leads to. A line has no rows.
TEST_F(ExplainTab, TheBorderOfALevelOfOneRowCanBeAskedFor) {
    open();
    texture().baseLevel = 6;
    texture().wrapT = Wrap::ClampToBorder;
    frames(2);
    const ImVec2 low = place("coord:0");
    const ImVec2 high = place("coord:2");
    const ImVec2 below((low.x + high.x) / 2, low.y + (low.y - high.y) * 0.2F);
    clickAt(below);
    ASSERT_TRUE(explaining().texel);
    EXPECT_EQ(explaining().texel->texel, (reference::TexelPlace{6, {0, -1, 0}}));
    unit().target = Target::Texture1D;
    frames(2);
    clickAt(below);
    ASSERT_TRUE(explaining().texel);
    EXPECT_EQ(explaining().texel->texel, (reference::TexelPlace{6, {0, 0, 0}}));
}

// Whichever texel of the image a pixel reads, the small pictures don't lie on it.
TEST_F(ExplainTab, SmallPicturesLeaveMostOfTheTextureInSight) {
    for (const float scale : {1.0F, 1.5F, 2.0F, 2.5F}) {
        SCOPED_TRACE(scale);
        start(defaultScene(), 1280, 800, scale);
        explainTheCube();
        ASSERT_NE(probedUnit(*session), nullptr);
        const Box plane = boxOf("texture space");
        float covered = 0;
        for (const std::string& name : itemsOf("patch:")) {
            covered += sharedArea(boxOf(name), boxOf(name));
            EXPECT_FALSE(overlaps(boxOf(name), boxOf("texel marks"))) << name;
        }
        EXPECT_LE(covered, 0.3F * sharedArea(plane, plane));
    }
}

TEST_F(ExplainTab, SmallPicturesDoNotCoverWhatTheyExplain) {
    open();
    int seen = 0;
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 6; ++x) {
            clickAt(
                {onTheCube().x + static_cast<float>(x - 3) * static_cast<float>(layout.picture.width) / 30,
                 onTheCube().y + static_cast<float>(y - 3) * static_cast<float>(layout.picture.height) / 20});
            if (!probedUnit(*session))
                continue;
            ++seen;
            for (const std::string& name : itemsOf("patch:"))
                EXPECT_FALSE(overlaps(boxOf(name), boxOf("texel marks"))) << name << x << y;
        }
    }
    EXPECT_GT(seen, 20);
}

TEST_F(ExplainTab, ShowsTheFaceOfACubeMap) {
    open();
    texture().pattern = Pattern::CubeFaces;
    unit().target = Target::CubeMap;
    frames(2);
    clickAt(onTheCube());
    const reference::UnitExplanation* found = probedUnit(*session);
    ASSERT_NE(found, nullptr);
    ASSERT_TRUE(found->sample.cube);
    ASSERT_FALSE(found->patches.empty());
    EXPECT_EQ(found->patches.front().layer, found->sample.cube->face);
    clickAt(inPatch());
    ASSERT_TRUE(explaining().texel);
    EXPECT_EQ(explaining().texel->texel.index.z, probedUnit(*session)->sample.cube->face);
    (void)picture();
}

// One texel a face: all others that are read lie beyond its edges.
TEST_F(ExplainTab, ATexelAcrossTheEdgeOfASeamlessCubeMapCanBeAskedFor) {
    open();
    texture().pattern = Pattern::CubeFaces;
    texture().minFilter = MinFilter::Linear;
    texture().baseLevel = 7;
    unit().target = Target::CubeMap;
    scene().passes[0].seamlessCubeMap = true;
    frames(2);
    clickAt(onTheCube());
    ASSERT_NE(probedUnit(*session), nullptr);
    const reference::LevelPatch patch = probedUnit(*session)->patches.front();
    EXPECT_TRUE(patch.seamless);
    const WidgetPlaces::Item item = places.items.at("patch:level 7");
    const float cell = (item.right - item.left) / static_cast<float>(patch.size.x);
    std::size_t across = 0;
    for (const reference::PlacedTap& tap : patch.taps) {
        const glm::vec2 middle = glm::vec2(tap.at - patch.low) + 0.5F;
        explaining().texel.reset();
        clickAt({item.left + middle.x * cell, item.bottom - middle.y * cell});
        ASSERT_TRUE(explaining().texel);
        EXPECT_EQ(explaining().texel->texel, (reference::TexelPlace{7, tap.tap.index}));
        across += tap.tap.index.z != patch.layer ? 1 : 0;
    }
    EXPECT_GT(across, 0U);
    (void)picture();
}

TEST_F(ExplainTab, ThePixelsOfATexelAreLitInTheColourOfWhatIsProbed) {
    explainTheCube();
    clickAt(inPatch());
    explaining().pixel.reset(); // its sign lies over the light, and the vertex's
    session->look.selection.vertex.reset();
    moveTo({5, 5});
    const Image lit = picture();
    const std::shared_ptr<const Image> light = explaining().light;
    ASSERT_NE(light, nullptr);
    explaining().texel.reset();
    const Image plain = picture();
    int strong = 0;
    for (int y = 0; y < light->height; ++y) {
        for (int x = 0; x < light->width; ++x) {
            const double alpha = std::to_integer<int>(light->at(x, y)[3]) / 255.0;
            if (alpha < 0.8)
                continue;
            ++strong;
            const int left = layout.picture.x + x;
            const int bottom = lit.height - layout.picture.bottom() + y;
            const ImU32 probed = color::probed;
            for (std::size_t i = 0; i < 3; ++i) {
                const double before = std::to_integer<int>(plain.at(left, bottom)[i]);
                const double now = std::to_integer<int>(lit.at(left, bottom)[i]);
                EXPECT_NEAR(now, alpha * ((probed >> (8 * i)) & 255U) + (1 - alpha) * before, 2)
                    << x << "," << y << " " << i;
            }
        }
    }
    EXPECT_GT(strong, 0);
}

TEST_F(ExplainTab, EscapeLetsGoOfTheTexelAndThenOfThePixel) {
    explainTheCube();
    clickAt(inPatch());
    ASSERT_TRUE(explaining().texel);
    key(key::escape);
    EXPECT_FALSE(explaining().texel);
    EXPECT_TRUE(explaining().pixel);
    key(key::escape);
    EXPECT_FALSE(explaining().pixel);
}

TEST_F(ExplainTab, AButtonLetsGoOfTheTexelWhereThereIsNoPixelToo) {
    explainTheCube();
    clickAt(inPatch());
    click("explain:clear texel");
    EXPECT_FALSE(explaining().texel);
    EXPECT_TRUE(explaining().pixel);
    EXPECT_FALSE(has("explain:clear texel"));
    clickAt(inPatch());
    explaining().pixel.reset();
    frames(2);
    click("explain:clear texel");
    EXPECT_FALSE(explaining().texel);
}

TEST_F(ExplainTab, ATexelGoesWithItsTexture) {
    open();
    const auto pick = [&] {
        explaining().pixel.reset();
        explaining().texel.reset();
        clickAt(onTheCube());
        clickAt(inPatch());
        ASSERT_TRUE(explaining().texel);
    };
    pick();
    texture().wrapS = Wrap::Clamp; // the same image, looked up otherwise
    frames(2);
    EXPECT_TRUE(explaining().texel);
    texture().pattern = Pattern::Brick;
    frames(2);
    EXPECT_FALSE(explaining().texel);
    pick();
    scene().textures.emplace_back().pattern = Pattern::UvTemplate;
    unit().texture = 1;
    frames(2);
    EXPECT_FALSE(explaining().texel);
    texture().pattern = Pattern::Brick;
    unit().texture = 0;
    frames(2);
    pick();
    unit().enabled = false;
    scene().textures.clear();
    frames(2);
    EXPECT_FALSE(explaining().texel);
}

TEST_F(ExplainTab, TheTitlesOfSmallPicturesFit) {
    for (const int width : {1280, 1024, 640}) {
        SCOPED_TRACE(width);
        start(defaultScene(), width, 700);
        open();
        for (const Target target : {Target::Texture2D, Target::CubeMap}) {
            texture().pattern = target == Target::CubeMap ? Pattern::CubeFaces : Pattern::Checker;
            unit().target = target;
            frames(2);
            explaining().pixel.reset();
            for (int step = 1; step < 20 && !probedUnit(*session); ++step) // until it hits a model
                clickAt(
                    {static_cast<float>(layout.picture.x + layout.picture.width * step / 20), onTheCube().y});
            ASSERT_NE(probedUnit(*session), nullptr);
            std::vector<Box> seen;
            for (const std::string& name : itemsOf("patch title:")) {
                const Box title = boxOf(name);
                EXPECT_LE(title.high.x, static_cast<float>(layout.texture.right())) << name;
                EXPECT_GE(title.low.x, static_cast<float>(layout.texture.x)) << name;
                for (const Box& other : seen)
                    EXPECT_FALSE(overlaps(title, other)) << name;
                seen.push_back(title);
            }
            EXPECT_FALSE(seen.empty());
        }
    }
}

// The cards of one unit side by side, without scrolling.
TEST_F(ExplainTab, TheCardsOfOneUnitFit) {
    for (const auto& [width, height, scale] : {std::tuple(1280, 800, 1.0F), std::tuple(1920, 1080, 1.0F),
                                               std::tuple(1920, 1080, 1.5F), std::tuple(3840, 2160, 2.0F)}) {
        SCOPED_TRACE(width);
        start(defaultScene(), width, height, scale);
        clickAt(onTheCube());
        for (const StageRow& row : stageRows)
            if (row.always)
                expectInTheDock(std::string("card:") + row.name);
        (void)picture();
    }
}

// A line of cards ends where a unit does.
TEST_F(ExplainTab, TheCardsOfAUnitStandInOneLine) {
    Scene two = defaultScene();
    Unit& second = two.passes[0].units[1];
    second.enabled = true;
    second.texture = 0;
    start(std::move(two));
    clickAt(onTheCube());
    for (const char* unit : {", unit 0", ", unit 1"}) {
        const float top = places.items.at(std::string("card:Coordinates") + unit).top;
        for (const char* stage : {"LOD", "Texels", "Filter", "Environment"})
            EXPECT_EQ(places.items.at(std::string("card:") + stage + unit).top, top) << stage << unit;
    }
    EXPECT_EQ(places.items.at("card:Vertices").top, places.items.at("card:LOD, unit 0").top);
    EXPECT_EQ(places.items.at("card:Pixel").top, places.items.at("card:LOD, unit 1").top);
    EXPECT_LT(places.items.at("card:LOD, unit 0").bottom, places.items.at("card:LOD, unit 1").top);
}

// Separate specular is a ninth card.
TEST_F(ExplainTab, NineCardsShareTheRoom) {
    for (const auto& [width, height, scale] : {std::tuple(1280, 800, 1.0F), std::tuple(1920, 1200, 1.5F)}) {
        SCOPED_TRACE(width);
        Scene shiny = defaultScene();
        shiny.light.colorControl = ColorControl::SeparateSpecular;
        shiny.passes[0].lighting = true;
        start(std::move(shiny), width, height, scale);
        clickAt(onTheCube());
        for (const char* name : {"card:Vertices", "card:Colour sum", "card:Pixel"})
            expectInTheDock(name);
        expectSoundFrame();
    }
}

TEST_F(ExplainTab, EightCardsFitIntoASmallWindow) {
    start(defaultScene(), 1024, 700);
    clickAt(onTheCube());
    expectInTheDock("card:Pixel");
}

TEST_F(ExplainTab, MoreCardsThanHaveRoomGoOnInAnotherLine) {
    for (int i = 1; i < 3; ++i) {
        scene().passes[0].units[static_cast<std::size_t>(i)] = scene().passes[0].units[0];
        scene().passes[0].units[static_cast<std::size_t>(i)].enabled = true;
    }
    frames(2);
    clickAt(onTheCube());
    ASSERT_TRUE(has("card:Vertices"));
    ASSERT_TRUE(has("card:Pixel"));
    EXPECT_GE(boxOf("card:Pixel").low.y, boxOf("card:Vertices").high.y);
    EXPECT_TRUE(places.items.at("card:Pixel").visible);
    for (const std::string& name : itemsOf("card:"))
        EXPECT_LE(boxOf(name).high.x, static_cast<float>(layout.belowDock.right())) << name;
}

// However large the text: what has no room goes on below.
TEST_F(ExplainTab, NothingScrollsSideways) {
    for (const Language language : {Language::English, Language::Russian, Language::Chinese}) {
        for (const auto& [width, height, scale] :
             {std::tuple(1280, 800, 2.5F), std::tuple(1280, 800, 2.0F), std::tuple(1920, 1080, 2.5F),
              std::tuple(1024, 700, 1.0F), std::tuple(1280, 800, 1.0F)}) {
            SCOPED_TRACE(fmt::format("{} at {} times {}", static_cast<int>(language), width, scale));
            Scene several = defaultScene();
            several.passes[0].units[1] = several.passes[0].units[0];
            start(std::move(several), width, height, scale);
            speak(language);
            clickAt(onTheCube());
            open();
            pinPixel(*session);
            const auto look = [&] {
                for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
                    const bool isPart = std::string_view(window->Name).find("explain") != std::string::npos;
                    EXPECT_TRUE(!isPart || !window->Active || window->ScrollMax.x == 0) << window->Name;
                }
            };
            frames(3);
            ASSERT_TRUE(has("explain:pixel"));
            look();
            for (const StageRow& row : stageRows) {
                states.details.explain.open.emplace(row.stage, -1);
                for (const int unit : {0, 1})
                    states.details.explain.open.emplace(row.stage, unit);
            }
            frames(3);
            look();
        }
    }
}

TEST_F(ExplainTab, CardsOpenToAllTheirNumbersSeveralAtOnce) {
    clickAt(onTheCube());
    EXPECT_FALSE(has("explain:rows of Level of detail"));
    click("card:LOD");
    EXPECT_TRUE(has("explain:rows of Level of detail"));
    click("card:Vertices");
    EXPECT_TRUE(has("explain:rows of Level of detail"));
    EXPECT_TRUE(has("explain:rows of Primary colour"));
    (void)picture();
    click("card:LOD");
    EXPECT_FALSE(has("explain:rows of Level of detail"));
    click("close card:Vertices");
    EXPECT_FALSE(has("explain:rows of Primary colour"));
}

TEST_F(ExplainTab, AnotherFragmentOfThePixelCanBeChosen) {
    clickAt(onTheCube());
    const reference::Explanation* found = explanationOf(*session);
    ASSERT_GT(found->fragments.size(), 1U); // its back
    ASSERT_EQ(found->fragments.back().outcome, reference::FragmentOutcome::FailedDepthTest);
    EXPECT_TRUE(has("card:Pixel"));
    click("explain:fragments");
    click("explain:fragment " + std::to_string(found->fragments.size() - 1));
    EXPECT_FALSE(has("card:Pixel")) << "it failed the depth test";
    EXPECT_TRUE(has("card:Tests"));
    clickAt({onTheCube().x + 9, onTheCube().y + 9});
    EXPECT_TRUE(has("card:Pixel")) << "another pixel shows what one sees";
}

TEST_F(ExplainTab, APinnedPixelStaysBesideTheNextOne) {
    clickAt(onTheCube());
    const auto first = explaining().pixel;
    EXPECT_FALSE(has("pinned card:LOD"));
    click("explain:pin");
    clickAt({onTheCube().x + 40, onTheCube().y + 20});
    ASSERT_NE(pinnedExplanation(*session), nullptr);
    EXPECT_EQ(pinnedExplanation(*session)->pixel, first);
    EXPECT_NE(explaining().pixel, first);
    EXPECT_TRUE(has("pinned card:LOD"));
    EXPECT_TRUE(has("card:LOD"));
    EXPECT_TRUE(has("pinned pixel"));
    (void)picture();
    openList();
    EXPECT_TRUE(has("explain:pinned"));
    open();
    click("explain:unpin");
    EXPECT_EQ(pinnedExplanation(*session), nullptr);
    EXPECT_FALSE(has("pinned pixel"));
}

TEST_F(ExplainTab, EscapeLetsGoOfThePinnedPixelFirst) {
    clickAt(onTheCube());
    click("explain:pin");
    key(key::escape);
    EXPECT_EQ(pinnedExplanation(*session), nullptr);
    EXPECT_TRUE(explaining().pixel);
}

TEST_F(ExplainTab, ShowsTheStagesBeforeThereIsAPixel) {
    for (const StageRow& row : stageRows)
        EXPECT_EQ(has(std::string("stage:") + row.name), row.always) << row.name;
    click("explain:middle");
    EXPECT_EQ(explaining().pixel,
              (reference::PixelPlace{layout.picture.width / 2, layout.picture.height / 2}));
}

TEST_F(ExplainTab, ADifferenceStandsOutBeyondTheToleranceAlone) {
    clickAt(onTheCube());
    const reference::Explanation& explanation = *explanationOf(*session);
    const auto inkAt = [&](int off) {
        reference::PixelBytes bytes = explanation.bytes;
        bytes[1] = static_cast<std::uint8_t>(bytes[1] + (bytes[1] < 128 ? off : -off));
        const Comparison found = comparedWith(bytes, explanation);
        EXPECT_EQ(found.most, off);
        return found.rows.at(1).cells.at(1);
    };
    session->view.tolerance = 2;
    EXPECT_EQ(inkAt(0).text, "the same");
    EXPECT_EQ(inkAt(1).text, "off by 1");
    EXPECT_EQ(inkAt(1).ink, reference::Ink::Plain);
    EXPECT_EQ(inkAt(2).ink, reference::Ink::Plain);
    EXPECT_EQ(inkAt(3).ink, reference::Ink::Bad);
    session->view.tolerance = 0;
    EXPECT_EQ(inkAt(1).ink, reference::Ink::Bad);
}

// What a renderer has where a tie falls otherwise is no warning.
TEST_F(ExplainTab, ATieIsNoWarning) {
    clickAt(onTheCube());
    reference::Explanation explanation = *explanationOf(*session);
    reference::PixelBytes other = explanation.bytes;
    other[1] = static_cast<std::uint8_t>(other[1] ^ 0x80U);
    const reference::StepCell bad = comparedWith(other, explanation).rows.at(1).cells.at(1);
    EXPECT_EQ(bad.text, "off by 128");
    EXPECT_EQ(bad.ink, reference::Ink::Bad);
    explanation.asRight = {other};
    const Comparison tie = comparedWith(other, explanation);
    EXPECT_EQ(tie.rows.at(1).cells.at(1).text, "off by 128: a tie, either is right");
    EXPECT_EQ(tie.rows.at(1).cells.at(1).ink, reference::Ink::Plain);
    EXPECT_EQ(tie.most, 0);
}

TEST_F(ExplainTab, OffersTheDriversMethodWhereThatIsWhatDiffers) {
    texture().pattern = Pattern::Checker;
    texture().maxAnisotropy = 16;
    scene().models[0].shape = Shape::Floor;
    scene().models[0].texCoords = {};
    frames(2);
    for (int i = 0; i < 40 && !has("explain:method"); ++i) {
        explaining().pixel = {10 + i * layout.picture.width / 50, layout.picture.height / 2 - i};
        (void)picture();
    }
    ASSERT_TRUE(has("explain:method"));
    ImGui::GetIO().MousePos = place("explain:use method"); // with a picture in every frame
    for (const bool down : {false, true, false}) {
        (void)picture();
        ImGui::GetIO().MouseDown[ImGuiMouseButton_Left] = down;
        (void)picture();
    }
    const DriverFacts& driver = session->document.diagnosis.driver;
    EXPECT_EQ(session->view.anisotropy, reference::anisotropyMethodOf(driver.renderer, driver.version));
    (void)picture();
    EXPECT_FALSE(has("explain:method"));
}

TEST_F(ExplainTab, ClearForgetsIt) {
    explainTheCube();
    click("explain:clear");
    EXPECT_FALSE(explaining().pixel);
    EXPECT_FALSE(explaining().answer);
    EXPECT_TRUE(has("explain:none"));
}

TEST_F(ExplainTab, DrawsWithoutAnyError) {
    explainTheCube();
    clickAt(inPatch());
    (void)picture();
    session->document.scene.textures[0].maxAnisotropy = 16;
    session->document.scene.models[0].shape = Shape::Floor;
    session->document.scene.models[0].texCoords = {};
    (void)picture();
    session->document.scene.models[0].texCoords[0] = TexCoords(4, glm::vec4(1e30F, -1e30F, 0, 0));
    (void)picture(testing::Each(testing::HasSubstr("drawn without anisotropy")));
}

} // namespace
} // namespace texplorer::ui::explain_tab_test

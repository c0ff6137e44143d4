// The program without a display: takes events and the time, returns frames and the time of the next one.

#include "app/stage/loop.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/widget_places.h"
#include "tests/stage/numbers_for_pictures.h"
#include "tests/support/no_threads.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <latch>

namespace texplorer::stage::loop_test {
namespace {

using testing::DoubleEq;
using testing::HasSubstr;
using testing::Optional;
using namespace std::chrono_literals;

constexpr Surface wide{{1280, 800}, {1280, 800}};
constexpr Surface minimised{{1280, 800}, {1280, 800}, 1, false};
constexpr double frame = 1.0 / 64; // exact in binary, so that sums of them are
constexpr int control = 341;
constexpr int shift = 340;

Scene spinning() {
    Scene scene = defaultScene();
    scene.models.front().spin = {0, 90, 0};
    return scene;
}

/// A host with its own clock.
class LoopTest : public testing::Test {
protected:
    void start(Scene scene = defaultScene(), ui::UnsavedWork* unsaved = nullptr, Clipboard clipboard = {}) {
        loop.reset();
        session.emplace(services.lend(unsaved), ui::Document{std::move(scene), ImageSource{}});
        loop.emplace(graphics, *session, wide, std::move(clipboard));
    }

    Step step(const std::vector<Event>& events = {}) {
        const int before = graphics.frames;
        last = loop->step(now, events);
        drawn += graphics.frames - before;
        return last;
    }

    /// Runs like a host: draws frames until the next call is later than the display's next picture.
    void run(std::vector<Event> events = {}) {
        drawn = 0;
        do {
            step(events);
            events.clear();
            now += frame;
            ASSERT_LT(drawn, 1000) << "it never rests";
        } while (last.wake && *last.wake < now);
    }

    [[nodiscard]] PointerMoved at(std::string_view name) const {
        const auto found = places.items.find(name);
        if (found == places.items.end()) {
            ADD_FAILURE() << name << " is not in sight";
            return {};
        }
        const ui::WidgetPlaces::Item& item = found->second;
        return {(item.left + item.right) / 2, (item.top + item.bottom) / 2};
    }

    NumbersForPictures graphics;
    ui::ServicesAtOnce services;
    ui::WidgetPlaces places;
    std::optional<ui::Session> session;
    std::optional<Loop> loop;
    double now = 1000;
    Step last;
    int drawn = 0; ///< frames of the last run
};

/// Measures a pair with each call, and counts what there is.
class CountingMeter final : public view::CostMeter {
public:
    CountingMeter(int calls, int& alive)
        : calls_(calls)
        , alive_(alive) {
        ++alive_;
    }
    ~CountingMeter() override { --alive_; }
    bool measure(view::TextureCosts& costs, std::chrono::milliseconds time) override {
        EXPECT_LE(time, 50ms) << "the window stays fluent";
        costs.front().times.b.push_back(1);
        return --calls_ > 0;
    }

private:
    int calls_;
    int& alive_;
};

TEST_F(LoopTest, CostsAreMeasuredFrameByFrameAndThenItSleeps) {
    start();
    run();
    int alive = 0;
    graphics.meter = std::make_unique<CountingMeter>(20, alive);
    session->cost.subject.emplace();
    run({Refresh{}});
    EXPECT_GE(drawn, 20);
    EXPECT_EQ(session->cost.costs.front().times.b.size(), 20U);
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(last.wake, std::nullopt);

    graphics.meter = std::make_unique<CountingMeter>(20, alive);
    session->cost.subject.emplace();
    step({Refresh{}});
    EXPECT_EQ(alive, 1);
    EXPECT_TRUE(last.unfinished);
    session->cost.subject.reset(); // Cancel
    run();
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(session->cost.costs.front().times.b.size(), 21U) << "what is measured stays";
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopTest, TheFigureOfCostsSleepsWithAndWithoutATexture) {
    for (const bool textured : {true, false}) {
        Scene scene = defaultScene();
        if (!textured)
            scene.textures.clear();
        start(scene);
        session->window.figure = ui::Figure::Cost;
        session->window.wantedTab = ui::Tab::Figures;
        run();
        EXPECT_EQ(last.wake, std::nullopt);
    }
}

TEST_F(LoopTest, AHostThatCannotMeasureEndsIt) {
    start();
    session->cost.subject.emplace();
    run();
    EXPECT_FALSE(session->cost.subject);
}

TEST_F(LoopTest, AWindowThatNobodyTouchesSleeps) {
    start();
    run();
    EXPECT_EQ(drawn, 3) << "until everything has its place";
    EXPECT_EQ(last.wake, std::nullopt);
    EXPECT_THAT(last.title, HasSubstr("Untitled"));
    EXPECT_EQ(step().wake, std::nullopt) << "a host that calls all the same has its frame";
    EXPECT_TRUE(last.drawn);
}

TEST_F(LoopTest, WhateverHappensIsFollowedByFramesThatPutItInItsPlace) {
    start();
    for (const Event& event : {Event(PointerMoved{100, 100}), Event(Refresh{}), Event(FocusChanged{true}),
                               Event(SurfaceChanged{{{900, 600}, {900, 600}}}),
                               Event(KeyChanged{KeyChanged::Kind::Repeat, 'E'})}) {
        run();
        run({event});
        EXPECT_EQ(drawn, 3) << event.index();
        EXPECT_EQ(last.wake, std::nullopt) << event.index();
    }
    EXPECT_EQ(graphics.pixels, (view::Size{900, 600}));
}

TEST_F(LoopTest, WhatPlaysIsDrawnWithEveryRefreshAndFollowsTheClock) {
    start(spinning());
    for (int i = 0; i < 20; ++i) {
        EXPECT_THAT(step().wake, Optional(now)) << "as soon as the display can";
        EXPECT_DOUBLE_EQ(session->look.playback.time, i * frame);
        now += frame;
    }
    session->look.playback.playing = false;
    run();
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopTest, KeyFramesPlayAndSleepWhileTimeStands) {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "0"}, {2, "view.azimuth", "90"}};
    start(std::move(scene));
    step();
    EXPECT_TRUE(last.wake) << "it plays";
    session->look.playback.playing = false;
    session->window.wantedTab = ui::Tab::Timeline;
    run({Refresh{}});
    EXPECT_EQ(last.wake, std::nullopt);
    EXPECT_TRUE(places.items.contains("key:view.azimuth@2"));
}

TEST_F(LoopTest, AfterALongPauseTheSceneGoesOnWhereItWas) {
    start(spinning());
    step();
    now += 3600;
    step();
    EXPECT_DOUBLE_EQ(session->look.playback.time, 0.1);
}

TEST_F(LoopTest, ATextCursorBlinks) {
    start();
    session->asking.dialog = ui::Dialog::SaveScene;
    run({Refresh{}});
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    EXPECT_THAT(last.wake, Optional(DoubleEq(now - frame + 0.4)));
    now = *last.wake;
    run();
    EXPECT_EQ(drawn, 1);
    EXPECT_THAT(last.wake, Optional(DoubleEq(now - frame + 0.4)));
}

TEST_F(LoopTest, ADialogDarkensTheWindowStepByStep) {
    start();
    run();
    session->asking.dialog = ui::Dialog::Help;
    run({Refresh{}});
    EXPECT_GT(drawn, 5);
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopTest, AnUploadGoesOnWithTheNextFrame) {
    start();
    run();
    graphics.uploading = true;
    step({Refresh{}});
    for (int i = 0; i < 20; ++i)
        EXPECT_THAT(step().wake, Optional(now));
    graphics.uploading = false;
    run();
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopTest, ASheetIsWrittenWhileTheWindowSleeps) {
    const test::TempDir folder;
    std::latch begun(1);
    std::latch goOn(1);
    bool first = true; // of the thread that works alone
    ui::FileWriting beside(When::WhenReady, [&] {
        if (std::exchange(first, false)) {
            begun.count_down();
            goOn.wait();
        }
    });
    const ui::Services all = services.lend();
    session.emplace(ui::Services{all.files, all.levels, all.reference, all.kept, all.probe, all.levelMap,
                                 all.patterns, all.levelPictures, all.lessons, all.environments,
                                 all.plainProbe, all.sheet, all.programs, beside});
    loop.emplace(graphics, *session, wide, Clipboard{});
    session->sheet.width = session->sheet.height = 16;
    ASSERT_TRUE(ui::saveSheet(*session, folder / "sheet.png"));
    begun.wait();
    run({Refresh{}});
    EXPECT_TRUE(places.items.contains("writing file"));
    EXPECT_EQ(last.wake, std::nullopt) << "the thread wakes it when there is news";
    goOn.count_down();
    beside.wait();
    run({Refresh{}});
    EXPECT_FALSE(places.items.contains("writing file"));
    EXPECT_THAT(session->look.notice.text, HasSubstr("Written: "));
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopTest, NobodySeesAMinimisedWindow) {
    start(spinning());
    run({SurfaceChanged{minimised}});
    EXPECT_EQ(drawn, 0);
    EXPECT_FALSE(last.drawn);
    EXPECT_EQ(last.wake, std::nullopt);
    run({SurfaceChanged{{{1280, 800}, {0, 0}}}});
    EXPECT_EQ(drawn, 0) << "nor one without pixels";
    now += 60;
    EXPECT_TRUE(step({SurfaceChanged{wide}}).drawn);
    EXPECT_LE(session->look.playback.time, 0.1) << "its time has not gone on meanwhile";
}

TEST_F(LoopTest, AWindowIsClosedAtOnceOrAfterAQuestion) {
    start();
    EXPECT_TRUE(step({CloseAsked{}}).quit);
    start();
    step({SurfaceChanged{minimised}});
    EXPECT_TRUE(step({CloseAsked{}}).quit) << "also where it is not seen";
    start();
    session->document.scene.material.shininess = 3;
    ui::recordEdit(*session, "Shininess");
    EXPECT_FALSE(step({CloseAsked{}}).quit);
    EXPECT_EQ(session->asking.dialog, ui::Dialog::Discard);
}

TEST_F(LoopTest, DroppedFilesAreOpened) {
    const test::TempDir folder;
    ASSERT_TRUE(writeFileAtomically(folder / "scene.json", viewBytes(R"({"version": 1})")));
    start();
    run({FilesDropped{{folder / "scene.json"}}});
    EXPECT_EQ(session->document.file, folder / "scene.json");
    EXPECT_THAT(last.title, HasSubstr("scene.json"));
}

TEST_F(LoopTest, AShortcutWithinOneFrameSaves) {
    const test::TempDir folder;
    start();
    session->document.file = folder / "scene.json";
    session->document.scene.material.shininess = 3;
    const Modifiers held{.control = true};
    using Kind = KeyChanged::Kind;
    run({KeyChanged{Kind::Press, control, held}, KeyChanged{Kind::Press, 'S', held},
         KeyChanged{Kind::Release, 'S', held}, KeyChanged{Kind::Release, control}});
    const Result<Bytes> saved = readFile(folder / "scene.json");
    ASSERT_TRUE(saved);
    EXPECT_EQ(
        parseScene({reinterpret_cast<const char*>(saved->data()), saved->size()}).value().material.shininess,
        3);
}

TEST_F(LoopTest, EveryClickWithinOneFrameCounts) {
    start(spinning());
    session->look.playback.speed = 0; // nothing moves, but the button is still shown
    run();
    const PointerMoved play = at("play");
    for (const int clicks : {1, 2, 3}) {
        session->look.playback.playing = true;
        std::vector<Event> events{play};
        for (int i = 0; i < clicks; ++i) {
            events.emplace_back(ButtonChanged{0, true});
            events.emplace_back(ButtonChanged{0, false});
        }
        run(events);
        EXPECT_EQ(session->look.playback.playing, clicks % 2 == 0) << clicks;
    }
}

TEST_F(LoopTest, TheLastInputOfAClickIsFollowedByFramesToo) {
    start();
    run();
    run({PointerMoved{100, 100}, ButtonChanged{0, true}, ButtonChanged{0, false}});
    EXPECT_GE(drawn, 5) << "three that take the input, and two that show the result";
}

TEST_F(LoopTest, AChoiceUnderThePointerIsDrawnWithTheNextFrame) {
    start();
    run();
    const auto wrap = [&] { return graphics.drawnScenes.at(view::Side::Now).textures.at(0).wrapS; };
    const PointerMoved choice = at("textures[0].wrapS=GL_CLAMP");
    const PointerMoved elsewhere = at("view");
    step({choice});
    EXPECT_EQ(wrap(), Wrap::Repeat);
    step();
    EXPECT_EQ(wrap(), Wrap::Clamp);
    run();
    EXPECT_EQ(last.wake, std::nullopt) << "nothing moves";
    step({elsewhere});
    step();
    EXPECT_EQ(wrap(), Wrap::Repeat);
    EXPECT_EQ(session->document.scene, session->document.saved);
}

TEST_F(LoopTest, ADragWithinOneFrameMovesTheCameraAsFar) {
    start();
    run();
    const View before = session->document.scene.view;
    const PointerMoved from{600, 300};
    const PointerMoved to{700, 300};
    run({from, ButtonChanged{0, true}, to, ButtonChanged{0, false}});
    const View turned = session->document.scene.view;
    EXPECT_NE(turned.azimuth, before.azimuth);
    EXPECT_EQ(turned.target, before.target);
    EXPECT_EQ(last.wake, std::nullopt);

    start();
    run();
    run({from, ButtonChanged{0, true}});
    for (int x = 610; x <= 700; x += 10)
        run({PointerMoved{static_cast<float>(x), 300}});
    run({ButtonChanged{0, false}});
    EXPECT_NEAR(session->document.scene.view.azimuth, turned.azimuth, 1e-3) << "as by a slow hand";

    start();
    run();
    const Modifiers held{.shift = true};
    using Kind = KeyChanged::Kind;
    run({from, KeyChanged{Kind::Press, shift, held}, ButtonChanged{0, true, held}, to,
         ButtonChanged{0, false, held}, KeyChanged{Kind::Release, shift}});
    EXPECT_EQ(session->document.scene.view.azimuth, before.azimuth);
    EXPECT_NE(session->document.scene.view.target, before.target) << "with Shift it is moved sideways";
}

TEST_F(LoopTest, TheClipboardIsTheHosts) {
    std::string kept = "from elsewhere";
    start(defaultScene(), nullptr, {[&] { return kept; }, [&](const std::string& text) { kept = text; }});
    EXPECT_STREQ(ImGui::GetClipboardText(), "from elsewhere");
    ImGui::SetClipboardText("from here");
    EXPECT_EQ(kept, "from here");
    ImGui::SetClipboardText("two\n\tlines\x1b[201~\u202e");
    EXPECT_EQ(kept, "two\n\tlines\\u001b[201~\\u202e") << "a terminal obeys nothing of it";
    start();
    EXPECT_EQ(ImGui::GetClipboardText(), nullptr) << "without a host's it is the window's own";
}

TEST_F(LoopTest, ThePointerShowsWhatItCanDo) {
    start();
    run();
    EXPECT_EQ(last.cursor, ImGuiMouseCursor_Arrow);
    run({at("left seam")});
    EXPECT_EQ(last.cursor, ImGuiMouseCursor_ResizeEW);
}

/// Unsaved work, with a clock that moves only when a test sets it.
class LoopsUnsavedWork : public LoopTest {
protected:
    void edit() {
        session->document.scene.material.shininess += 1;
        ui::recordEdit(*session, "Shininess");
        run({Refresh{}});
    }
    [[nodiscard]] std::ptrdiff_t drafts() const {
        const std::filesystem::path unsaved = folder / "unsaved";
        if (!std::filesystem::exists(unsaved))
            return 0;
        return std::ranges::count_if(std::filesystem::directory_iterator(unsaved),
                                     [](const auto& entry) { return entry.path().extension() == ".scene"; });
    }
    test::TempDir folder;
};

TEST_F(LoopsUnsavedWork, WithoutAThreadTheLoopWritesItWhenItIsDue) {
    const test::NoThreads none;
    ui::UnsavedWork unsaved(folder / "unsaved", {}, 1500ms, [this] { return now; });
    start(defaultScene(), &unsaved);
    run();
    EXPECT_EQ(last.wake, std::nullopt);
    edit();
    ASSERT_TRUE(last.wake);
    EXPECT_EQ(drafts(), 0);
    const double due = *last.wake;
    EXPECT_GT(due, now + 1);
    EXPECT_LE(due, now + 1.5);
    run({PointerMoved{100, 100}});
    EXPECT_THAT(last.wake, Optional(due)) << "nothing is written before";
    EXPECT_EQ(drafts(), 0);
    now = due;
    run();
    EXPECT_EQ(drafts(), 1);
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopsUnsavedWork, AMinimisedWindowWritesItToo) {
    const test::NoThreads none;
    ui::UnsavedWork unsaved(folder / "unsaved", {}, 1500ms, [this] { return now; });
    start(defaultScene(), &unsaved);
    run();
    edit();
    run({SurfaceChanged{minimised}});
    ASSERT_TRUE(last.wake);
    now = *last.wake;
    run();
    EXPECT_EQ(drafts(), 1);
    EXPECT_EQ(last.wake, std::nullopt);
}

TEST_F(LoopsUnsavedWork, AThreadOfItsOwnNeedsNoFrame) {
    ui::UnsavedWork unsaved(folder / "unsaved", {}, 24h);
    start(defaultScene(), &unsaved);
    run();
    edit();
    EXPECT_EQ(last.wake, std::nullopt);
    EXPECT_TRUE(unsaved.autosave.flush());
    EXPECT_EQ(drafts(), 1);
}

} // namespace
} // namespace texplorer::stage::loop_test

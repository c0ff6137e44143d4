#include "tests/random/monkey_trial.h"

#include "app/ui/model/playback.h"
#include "app/ui/widgets/keys.h"
#include "tests/random/random_scene.h"
#include "tests/ui/edits.h"
#include "tests/ui/window_sizes.h"
#include "texplorer/scene/params/json.h"

#include <array>

namespace texplorer::random {

namespace {

using namespace ui;

constexpr int actions = 60;
constexpr std::array keys{int{'K'},  int{'T'},   int{'Z'}, int{'Y'}, int{'F'},  int{'M'}, int{'E'},
                          int{'1'},  int{'2'},   int{'3'}, int{'4'}, key::home, key::f1,  key::space,
                          key::down, key::enter, key::tab, int{'N'}, int{'L'},  key::del};

} // namespace

MonkeyTrial::MonkeyTrial(unsigned seed, int number, Journal& journal)
    : WindowTrial(journal) {
    std::seed_seq both{seed, static_cast<unsigned>(number)};
    random_.seed(both);
    step("start");
    // Every second scene is random; the trials do not use files. The window is small: work that the window
    // leaves to its workers, such as finding the pixels of a texel, is done at once here.
    const bool strange = below(2) == 0;
    const test::WindowSize& size =
        test::windowSizes[strange ? 0 : static_cast<std::size_t>(random_() % test::windowSizes.size())];
    width_ = size.width;
    height_ = size.height;
    start(strange ? randomScene(seed, number, {}).scene : defaultScene(), width_, height_,
          test::windowScales[random_() % test::windowScales.size()]);
    initial_ = this->scene();
}

int MonkeyTrial::below(int end) {
    return static_cast<int>(random_() % static_cast<unsigned>(end));
}

ImVec2 MonkeyTrial::somewhere() {
    const int x = below(width_);
    return {static_cast<float>(x), static_cast<float>(below(height_))};
}

void MonkeyTrial::act() {
    const ImVec2 place = somewhere();
    const auto at = [&](std::string_view what) {
        step("action " + std::to_string(action_) + ": " + std::string(what) + " at " +
             std::to_string(static_cast<int>(place.x)) + "," + std::to_string(static_cast<int>(place.y)));
    };
    switch (below(8)) {
    case 0: {
        at("drag");
        const float right = static_cast<float>(below(600) - 300);
        const float down = static_cast<float>(below(300) - 150);
        drag(place, {right, down}, below(3));
        break;
    }
    case 1:
        at("wheel");
        wheel(place, static_cast<float>(below(9) - 4));
        break;
    case 2:
        at("key");
        moveTo(place);
        key(keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))]);
        break;
    case 3:
        at("undo or redo");
        key(below(2) == 0 ? 'Z' : 'Y', {test::ctrl});
        break;
    case 4:
        at("double click");
        doubleClickAt(place);
        break;
    default:
        at("click");
        clickAt(place, below(4) == 0 ? ImGuiMouseButton_Right : ImGuiMouseButton_Left);
    }
    if (session->asking.dialog != Dialog::None)
        key(key::escape);
    advance(*session, 0.01);
}

/// The scene can be written as text: coordinates of an earlier shape of a model are not written.
void MonkeyTrial::look() {
    const Result<Scene> read = parseScene(writeScene(scene()));
    ASSERT_TRUE(read.has_value()) << "action " << action_ << ": " << describe(read.error());
    ASSERT_EQ(writeScene(*read), writeScene(scene())) << "action " << action_;
    ASSERT_EQ(session->document.history.current(), scene()) << "action " << action_ << " was not recorded";
    expectSoundFrame();
}

void MonkeyTrial::run() {
    for (action_ = 0; action_ < actions && !hasFailed(); ++action_) {
        act();
        look();
    }
    step("undo all");
    while (session->document.history.canUndo())
        take(*session, Undo{});
    initial_.view.distance = scene().view.distance; // follows the shape of the view, which is not an edit
    EXPECT_EQ(scene(), initial_);
}

} // namespace texplorer::random

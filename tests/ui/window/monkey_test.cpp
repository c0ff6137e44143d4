// Hands that know nothing: whatever they press, the window goes on and the scene stays one that a file can
// hold.

#include "app/ui/widgets/keys.h"
#include "core/scene/params/json.h"
#include "tests/ui/workbench.h"

#include <random>

namespace texplorer::ui::test {
namespace {

class Monkey : public Workbench, public testing::WithParamInterface<unsigned> {};

TEST_P(Monkey, CannotBreakTheWindow) {
    std::mt19937 random(GetParam());
    const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    const auto somewhere = [&] {
        return ImVec2(static_cast<float>(below(1280)), static_cast<float>(below(800)));
    };
    constexpr int keys[] = {'Z', 'Y', 'F', key::home, key::space, key::f1, key::down, key::enter, key::tab};
    const Scene initial = scene();
    for (int action = 0; action < 300; ++action) {
        switch (below(6)) {
        case 0:
            drag(somewhere(), {static_cast<float>(below(600) - 300), static_cast<float>(below(300) - 150)},
                 below(3));
            break;
        case 1:
            wheel(somewhere(), static_cast<float>(below(9) - 4));
            break;
        case 2:
            key(keys[below(std::size(keys))]);
            break;
        case 3:
            key(below(2) == 0 ? 'Z' : 'Y', {ctrl});
            break;
        default:
            clickAt(somewhere(), below(4) == 0 ? ImGuiMouseButton_Right : ImGuiMouseButton_Left);
        }
        if (session->window.dialog != Dialog::None) // files are not for monkeys
            key(key::escape);
        advance(*session, 0.01);
        const Result<Scene> read = parseScene(writeScene(scene()));
        ASSERT_TRUE(read.has_value()) << "action " << action << ": " << describe(read.error());
        // As text: coordinates that belong to an earlier shape of a model are not written.
        ASSERT_EQ(writeScene(*read), writeScene(scene())) << "action " << action;
        ASSERT_EQ(session->document.history.current(), scene()) << "action " << action << " was not recorded";
    }
    while (session->document.history.canUndo())
        undo(*session);
    EXPECT_EQ(scene(), initial);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Monkey, testing::Range(1U, 4U));

} // namespace
} // namespace texplorer::ui::test

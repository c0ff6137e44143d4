// Large controls: a finger finds each of them, in every panel.

#include "app/ui/files/lessons.h"
#include "app/ui/state/figures.h"
#include "app/ui/state/sections.h"
#include "tests/ui/workbench.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace texplorer::ui::large_controls_test {
namespace {

using namespace test;

/// Handles, marks and words within pictures, tables and code.
constexpr std::array<std::string_view, 10> parts{"block:",  "call:",        "cell:", "command:", "edge:",
                                                 "emboss:", "environment:", "flip:", "levels:",  "vertex:"};
/// The reset sign of a row, whose menu does the same; the switch within a unit's button; the edge of a panel.
constexpr std::array<std::string_view, 3> ends{"#reset", " on", " seam"};

class LargeControls : public Workbench {
protected:
    LargeControls() {
        session->settings.largeControls = true;
        frames(3);
    }

    /// The names and sizes of those that are too small.
    [[nodiscard]] std::set<std::string> small() {
        const ImVec2 beyond = ImGui::GetStyle().TouchExtraPadding;
        std::set<std::string> names;
        for (const auto& [name, item] : places.items) {
            const auto begins = [&name = name](std::string_view part) { return name.starts_with(part); };
            const auto finishes = [&name = name](std::string_view end) { return name.ends_with(end); };
            if (!item.reacts || !item.visible || std::ranges::any_of(parts, begins) ||
                std::ranges::any_of(ends, finishes))
                continue;
            ++looked;
            const float width = item.right - item.left + 2 * beyond.x;
            const float height = item.bottom - item.top + 2 * beyond.y;
            if (width < 28 || height < 40)
                names.insert(fmt::format("{} {:.0f}x{:.0f}", name, width, height));
        }
        return names;
    }

    int looked = 0; ///< at how many
};

TEST_F(LargeControls, AreAtLeastFortyPixelsHigh) {
    std::set<std::string> all;
    for (const TabRow& tab : tabRows) {
        session->window.wantedTab = tab.tab;
        for (const SectionRow& section : sectionRows) {
            session->out.wantedSection = section.section;
            frames(3);
            all.merge(small());
        }
    }
    for (const FigureRow& figure : figureRows) {
        session->window.wantedTab = Tab::Figures;
        session->window.figure = figure.figure;
        frames(3);
        all.merge(small());
    }
    for (const char* menu :
         {"menu:File", "menu:Edit", "menu:View", "menu:Lessons", "menu:Presets", "menu:A/B", "menu:Help"}) {
        click(menu);
        frames(2);
        all.merge(small());
        key(256);
    }
    EXPECT_THAT(all, testing::IsEmpty());
    EXPECT_GT(looked, 1000);
}

TEST_F(LargeControls, AreWholeInTheStatusBar) {
    texture().mipmaps = MipPolicy::None;
    texture().minFilter = MinFilter::NearestMipmapNearest;
    frames(3);
    const auto fix =
        std::ranges::find_if(places.items, [](const auto& each) { return each.first.starts_with("fix:"); });
    ASSERT_NE(fix, places.items.end());
    EXPECT_GE(fix->second.top, static_cast<float>(layout.status.y));
    EXPECT_LE(fix->second.bottom, static_cast<float>(layout.status.bottom()));
}

TEST_F(LargeControls, APhoneHasOnePanelThatAListChooses) {
    resize(360, 740);
    frames(3);
    EXPECT_FALSE(layout.parameters.isEmpty());
    click("lower panel");
    frames(2);
    click("lower:Vertices");
    frames(2);
    EXPECT_TRUE(layout.parameters.isEmpty());
    EXPECT_TRUE(has("vertex:0"));
    click("maximise:lower");
    frames(2);
    EXPECT_TRUE(layout.view.isEmpty());
    click("lower panel");
    frames(2);
    click("lower:Parameters");
    frames(2);
    EXPECT_FALSE(layout.parameters.isEmpty());
    EXPECT_FALSE(layout.view.isEmpty());
    moveTo(place("view"));
    key('E');
    frames(3);
    EXPECT_FALSE(layout.of(dockOf(session->settings.workspace, Tab::Explain)).isEmpty())
        << "what was asked for";
}

TEST_F(LargeControls, AStepOfALessonKeepsItsTextInFront) {
    resize(360, 740);
    frames(2);
    ASSERT_TRUE(openLessonNamed(*session, "wrap", 2)); // it looks at Explain and a parameter
    frames(3);
    const Workspace& workspace = session->settings.workspace;
    EXPECT_EQ(frontOf(workspace, dockOf(workspace, Tab::Lesson)), Tab::Lesson);
    EXPECT_FALSE(layout.of(dockOf(workspace, Tab::Lesson)).isEmpty());
}

} // namespace
} // namespace texplorer::ui::large_controls_test

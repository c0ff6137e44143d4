#pragma once

#include "app/ui/model/details_tabs.h"
#include "core/base/result.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// What the seams between panels were dragged to; 0 leaves the choice to the layout.
struct Seams {
    float parameters = 0; ///< width of the left column, in unscaled pixels
    float details = 0;    ///< width of the right column, in unscaled pixels
    float split = 0;      ///< the share of the right column's height that the texture space takes, 0 to 1
    float below = 0;      ///< the share of the window's height that the dock below takes, 0 to 1

    bool operator==(const Seams&) const = default;
};

struct TabPlace {
    Dock dock = Dock::Below;
    bool open = true; ///< a closed tab opens where it was

    bool operator==(const TabPlace&) const = default;
};

/// What fills the window for a while: the view everything, the others all but the parameters.
enum class Maximised { None, View, TextureSpace, Right, Below };

/// Which panels are open, where they are and how large: a value that outlives the window. A dock in which no
/// tab is open isn't there, and takes no room.
struct Workspace {
    bool parameters = true;
    bool textureSpace = true;
    std::array<TabPlace, tabRows.size()> tabs = atHome();                ///< by Tab
    std::array<Tab, dockRows.size()> front{Tab::Vertices, Tab::Explain}; ///< by Dock; see frontOf
    Seams seams;
    Maximised maximised = Maximised::None; ///< not remembered

    bool operator==(const Workspace&) const = default;

private:
    [[nodiscard]] static constexpr std::array<TabPlace, tabRows.size()> atHome() {
        std::array<TabPlace, tabRows.size()> places;
        for (const TabRow& row : tabRows)
            places[static_cast<std::size_t>(row.tab)] = {row.home, row.tab != Tab::Lesson};
        return places;
    }
};

[[nodiscard]] bool isOpen(const Workspace& workspace, Tab tab);
[[nodiscard]] Dock dockOf(const Workspace& workspace, Tab tab);

/// The tab that one sees in a dock; none: nothing is open in it.
[[nodiscard]] std::optional<Tab> frontOf(const Workspace& workspace, Dock dock);

/// Whether one sees it: in front, and not behind something maximised.
[[nodiscard]] bool isShown(const Workspace& workspace, Tab tab);

/// What is maximised and there.
[[nodiscard]] Maximised maximisedOf(const Workspace& workspace);
[[nodiscard]] constexpr Maximised maximised(Dock dock) {
    return dock == Dock::Right ? Maximised::Right : Maximised::Below;
}

/// Opens the tab where it lies and brings it to the front, before whatever is maximised.
void showTab(Workspace& workspace, Tab tab);
void closeTab(Workspace& workspace, Tab tab);
/// Opens it in this dock, in front.
void moveTab(Workspace& workspace, Tab tab, Dock dock);
void toggleMaximised(Workspace& workspace, Maximised what);

/// An arrangement that has a name. To choose one gives the seams back to the layout.
struct LayoutRow {
    std::string_view name; ///< for texshot's --layout
    const char* label;
    const char* help;
    bool parameters;
    bool textureSpace;
    bool docks; ///< all tabs are open; else none
};

inline constexpr std::array layoutRows{
    LayoutRow{"student", "Student", "Parameters, view and texture space, with Explain below", true, true,
              true},
    LayoutRow{"teacher", "Teacher", "A large view beside parameters and texture space, for a projector", true,
              true, false},
    LayoutRow{"minimal", "Minimal", "The view alone", false, false, false},
};

[[nodiscard]] Workspace workspaceOf(const LayoutRow& row);
/// The same, beside a lesson that is open.
void chooseLayout(Workspace& workspace, const LayoutRow& row);
/// The layout that it still is, wherever the seams are, whichever tab is in front, and whether there is a
/// lesson; nullptr: none.
[[nodiscard]] const LayoutRow* layoutOf(const Workspace& workspace);

/// As JSON, for the settings' file; parseWorkspace(writeWorkspace(w)) == w while nothing is maximised.
[[nodiscard]] std::string writeWorkspace(const Workspace& workspace);

/// What the text leaves out, and tabs that it doesn't know, are as they are at the start; keys that nobody
/// knows are left alone. Refused, with the JSON pointer in Error::where: what is no JSON, wrong types, docks
/// and tabs that there aren't, sizes that aren't finite or are below 0.
[[nodiscard]] Result<Workspace> parseWorkspace(std::string_view json);

} // namespace texplorer::ui

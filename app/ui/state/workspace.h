#pragma once

#include "app/ui/state/details_tabs.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// The positions of dragged seams between panels; 0: chosen by the layout.
struct Seams {
    float parameters = 0; ///< width of the left column, in unscaled pixels
    float details = 0;    ///< width of the right column, in unscaled pixels
    float split = 0;      ///< the texture space's fraction of the right column's height, 0 to 1
    float below = 0;      ///< the fraction of the window's height for the dock below, 0 to 1

    bool operator==(const Seams&) const = default;
};

struct TabPlace {
    Dock dock = Dock::Below;
    bool open = true; ///< a closed tab remembers its place

    bool operator==(const TabPlace&) const = default;
};

/// The maximised panel: the view fills the whole window, the others all except the parameters.
enum class Maximised { None, View, TextureSpace, Right, Below };

/// The panels around the view. A dock is there if one of its tabs is open.
enum class Panel { Parameters, TextureSpace, Right, Below };
struct PanelRow {
    Panel panel;
    std::string_view name; ///< in the settings file
};
inline constexpr std::array panelRows{
    PanelRow{Panel::Parameters, "parameters"},
    PanelRow{Panel::TextureSpace, "textureSpace"},
    PanelRow{Panel::Right, "right"},
    PanelRow{Panel::Below, "below"},
};

/// Which panels are open, their places and sizes: a value that is kept between windows. A dock without open
/// tabs takes no room.
struct Workspace {
    bool parameters = true;
    bool textureSpace = true;
    std::array<TabPlace, tabRows.size()> tabs = atHome();                ///< by Tab
    std::array<Tab, dockRows.size()> front{Tab::Vertices, Tab::Explain}; ///< by Dock; see frontOf
    Panel sheet = Panel::Parameters;                                     ///< in a narrow window; see sheetOf
    Seams seams;
    Maximised maximised = Maximised::None; ///< not saved

    bool operator==(const Workspace&) const = default;

private:
    [[nodiscard]] static constexpr std::array<TabPlace, tabRows.size()> atHome() {
        std::array<TabPlace, tabRows.size()> places;
        for (const TabRow& row : tabRows)
            places[static_cast<std::size_t>(row.tab)] = {row.home, row.tab != Tab::Lesson};
        return places;
    }
};

[[nodiscard]] constexpr Panel panelOf(Dock dock) {
    return dock == Dock::Right ? Panel::Right : Panel::Below;
}

[[nodiscard]] bool isOpen(const Workspace& workspace, Tab tab);
[[nodiscard]] Dock dockOf(const Workspace& workspace, Tab tab);

/// The visible tab of a dock; none: no tab is open in it.
[[nodiscard]] std::optional<Tab> frontOf(const Workspace& workspace, Dock dock);

/// The panel that a narrow window shows below the view: the chosen one, or, if it is not there, the first
/// one; none: no panel is there.
[[nodiscard]] std::optional<Panel> sheetOf(const Workspace& workspace);

/// Whether a tab is visible: in front, and not hidden by something maximised.
[[nodiscard]] bool isShown(const Workspace& workspace, Tab tab);

/// The maximised panel, if it exists.
[[nodiscard]] Maximised maximisedOf(const Workspace& workspace);
[[nodiscard]] constexpr Maximised maximised(Dock dock) {
    return dock == Dock::Right ? Maximised::Right : Maximised::Below;
}

/// Opens the tab in its dock and brings it to the front; restores a maximised panel that hides it.
void showTab(Workspace& workspace, Tab tab);
void closeTab(Workspace& workspace, Tab tab);
/// Moves the tab to this dock, opens it and brings it to the front.
void moveTab(Workspace& workspace, Tab tab, Dock dock);
void toggleMaximised(Workspace& workspace, Maximised what);

/// A named arrangement. Choosing one resets the seams.
struct LayoutRow {
    std::string_view name; ///< for texshot's --layout
    const char* label;
    const char* help;
    bool parameters;
    bool textureSpace;
    bool docks; ///< all tabs are open; else none
};

inline constexpr std::array layoutRows{
    LayoutRow{"student", N_("Student"), N_("Parameters, view and texture space, with Explain below"), true,
              true, true},
    LayoutRow{"teacher", N_("Teacher"),
              N_("A large view next to parameters and texture space, for a projector"), true, true, false},
    LayoutRow{"minimal", N_("Minimal"), N_("Only the view"), false, false, false},
};

[[nodiscard]] Workspace workspaceOf(const LayoutRow& row);
/// The same, with the tab of an open lesson.
void chooseLayout(Workspace& workspace, const LayoutRow& row);
/// The layout that the workspace has, regardless of seams, front tabs and an open lesson; nullptr: none.
[[nodiscard]] const LayoutRow* layoutOf(const Workspace& workspace);

/// As JSON, for the settings file; parseWorkspace(writeWorkspace(w)) == w if nothing is maximised.
[[nodiscard]] std::string writeWorkspace(const Workspace& workspace);

/// Missing values and tabs have their initial state; unknown keys and the names of unknown front tabs are
/// ignored. None: invalid JSON, wrong types, unknown docks, and sizes out of range.
[[nodiscard]] std::optional<Workspace> parseWorkspace(std::string_view json);

} // namespace texplorer::ui

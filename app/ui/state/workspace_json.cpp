#include "app/ui/state/workspace.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::ui {
namespace {

using WorkspaceJson = nlohmann::ordered_json;

struct ShownRow {
    std::string_view name;
    bool Workspace::*member;
};
constexpr std::array shownRows{
    ShownRow{"parameters", &Workspace::parameters},
    ShownRow{"textureSpace", &Workspace::textureSpace},
};

struct SeamRow {
    std::string_view name;
    float Seams::*member;
    float max;
};
constexpr std::array seamRows{
    SeamRow{"parameters", &Seams::parameters, 1e5F},
    SeamRow{"details", &Seams::details, 1e5F},
    SeamRow{"split", &Seams::split, 1},
    SeamRow{"below", &Seams::below, 1},
};

/// The row with this name, among those that a reader knows.
template<class Rows>
const auto* rowNamed(const Rows& rows, const WorkspaceJson& name) {
    const auto found = std::ranges::find_if(rows, [&](const auto& row) {
        return name.is_string() && name.get_ref<const std::string&>() == row.name;
    });
    return found == rows.end() ? nullptr : &*found;
}

/// Whether `read` accepts the member of an object, if it has it.
template<class Read>
bool readMember(const WorkspaceJson& object, std::string_view name, const Read& read) {
    if (!object.is_object())
        return false;
    const auto member = object.find(name);
    return member == object.end() || read(*member);
}

/// The same for each row's member.
template<class Rows, class Read>
bool readMembers(const WorkspaceJson& object, const Rows& rows, const Read& read) {
    return std::ranges::all_of(rows, [&](const auto& row) {
        return readMember(object, row.name, [&](const WorkspaceJson& value) { return read(row, value); });
    });
}

bool readSwitch(const WorkspaceJson& value, bool& isOn) {
    if (value.is_boolean())
        isOn = value.get<bool>();
    return value.is_boolean();
}

bool readDock(const WorkspaceJson& value, Dock& dock) {
    const DockRow* named = rowNamed(dockRows, value);
    if (named)
        dock = named->dock;
    return named != nullptr;
}

bool readSheet(const WorkspaceJson& value, Panel& sheet) {
    const PanelRow* named = rowNamed(panelRows, value);
    if (named)
        sheet = named->panel;
    return named != nullptr;
}

bool readTab(const WorkspaceJson& tab, TabPlace& place) {
    return readMember(tab, "dock", [&](const WorkspaceJson& value) { return readDock(value, place.dock); }) &&
           readMember(tab, "open", [&](const WorkspaceJson& value) { return readSwitch(value, place.open); });
}

bool readFront(const WorkspaceJson& value, Tab& front) {
    if (const TabRow* tab = rowNamed(tabRows, value)) // otherwise from another version
        front = tab->tab;
    return value.is_string();
}

bool readSeam(const WorkspaceJson& value, float max, float& seam) {
    const float number = value.is_number() ? value.get<float>() : -1;
    const bool isWithin = number >= 0 && number <= max;
    if (isWithin)
        seam = number;
    return isWithin;
}

} // namespace

std::string writeWorkspace(const Workspace& workspace) {
    WorkspaceJson json;
    for (const ShownRow& row : shownRows)
        json[std::string(row.name)] = workspace.*row.member;
    for (const TabRow& row : tabRows)
        json["tabs"][std::string(row.name)] = {{"dock", rowOf(dockOf(workspace, row.tab)).name},
                                               {"open", isOpen(workspace, row.tab)}};
    for (const DockRow& row : dockRows)
        json["front"][std::string(row.name)] =
            rowOf(workspace.front[static_cast<std::size_t>(row.dock)]).name;
    json["sheet"] = std::ranges::find(panelRows, workspace.sheet, &PanelRow::panel)->name;
    for (const SeamRow& row : seamRows)
        json["seams"][std::string(row.name)] = workspace.seams.*row.member;
    return json.dump(2) + "\n";
}

std::optional<Workspace> parseWorkspace(std::string_view text) {
    const WorkspaceJson json = WorkspaceJson::parse(text, nullptr, false);
    Workspace workspace;
    const auto part = [&](std::string_view name, const auto& rows, const auto& read) {
        return readMember(json, name,
                          [&](const WorkspaceJson& value) { return readMembers(value, rows, read); });
    };
    const auto shown = [&](const ShownRow& row, const WorkspaceJson& value) {
        return readSwitch(value, workspace.*row.member);
    };
    const auto tab = [&](const TabRow& row, const WorkspaceJson& value) {
        return readTab(value, workspace.tabs[static_cast<std::size_t>(row.tab)]);
    };
    const auto front = [&](const DockRow& row, const WorkspaceJson& value) {
        return readFront(value, workspace.front[static_cast<std::size_t>(row.dock)]);
    };
    const auto seam = [&](const SeamRow& row, const WorkspaceJson& value) {
        return readSeam(value, row.max, workspace.seams.*row.member);
    };
    const bool isKnown = readMembers(json, shownRows, shown) && part("tabs", tabRows, tab) &&
                         part("front", dockRows, front) && part("seams", seamRows, seam) &&
                         readMember(json, "sheet", [&](const WorkspaceJson& value) {
                             return readSheet(value, workspace.sheet);
                         });
    return isKnown ? std::optional(workspace) : std::nullopt;
}

} // namespace texplorer::ui

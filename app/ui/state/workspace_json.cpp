#include "app/ui/state/workspace.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::ui {
namespace {

using WorkspaceJson = nlohmann::ordered_json;

struct ShownRow {
    const char* key;
    bool Workspace::*member;
};
constexpr std::array shownRows{
    ShownRow{"parameters", &Workspace::parameters},
    ShownRow{"textureSpace", &Workspace::textureSpace},
};

struct SeamRow {
    const char* key;
    float Seams::*member;
    float max;
};
constexpr std::array seamRows{
    SeamRow{"parameters", &Seams::parameters, 1e5F},
    SeamRow{"details", &Seams::details, 1e5F},
    SeamRow{"split", &Seams::split, 1},
    SeamRow{"below", &Seams::below, 1},
};

/// The value for a message: hostile text may be deep or long.
std::string foundText(const WorkspaceJson& value) {
    constexpr std::size_t maxShown = 40;
    const std::string text = value.is_primitive() ? value.dump() : std::string(value.type_name());
    return text.size() > maxShown ? std::string(value.type_name()) : text;
}

/// The row with this name, among those that a reader knows.
template<class Rows>
const auto* rowNamed(const Rows& rows, const WorkspaceJson& name) {
    const auto found = std::ranges::find_if(rows, [&](const auto& row) {
        return name.is_string() && name.get_ref<const std::string&>() == row.name;
    });
    return found == rows.end() ? nullptr : &*found;
}

template<class Rows>
std::string workspaceNames(const Rows& rows) {
    std::string names;
    for (const auto& row : rows)
        names.append(names.empty() ? "" : ", ").append(row.name);
    return names;
}

/// Whether there is such a member; it must be an object.
Result<const WorkspaceJson*> objectIn(const WorkspaceJson& owner, const char* key) {
    const auto found = owner.find(key);
    if (found == owner.end())
        return nullptr;
    if (!found->is_object())
        return fail(ErrorCode::Malformed, fmt::format("expected an object, found {}", foundText(*found)),
                    fmt::format("/{}", key));
    return &*found;
}

Result<void> readTab(const WorkspaceJson& value, const TabRow& row, Workspace& workspace) {
    const std::string where = fmt::format("/tabs/{}", row.name);
    if (!value.is_object())
        return fail(ErrorCode::Malformed, fmt::format("expected an object, found {}", foundText(value)),
                    where);
    TabPlace& place = workspace.tabs[static_cast<std::size_t>(row.tab)];
    if (const auto dock = value.find("dock"); dock != value.end()) {
        const DockRow* named = rowNamed(dockRows, *dock);
        if (!named)
            return fail(
                ErrorCode::OutOfRange,
                fmt::format("expected one of {}, found {}", workspaceNames(dockRows), foundText(*dock)),
                where + "/dock");
        place.dock = named->dock;
    }
    if (const auto open = value.find("open"); open != value.end()) {
        if (!open->is_boolean())
            return fail(ErrorCode::Malformed,
                        fmt::format("expected true or false, found {}", foundText(*open)), where + "/open");
        place.open = open->get<bool>();
    }
    return {};
}

Result<void> readTabs(const WorkspaceJson& json, Workspace& workspace) {
    const auto tabs = objectIn(json, "tabs");
    if (!tabs)
        return fail(tabs.error());
    for (const TabRow& row : tabRows) {
        if (!*tabs || !(*tabs)->contains(row.name))
            continue;
        if (const auto read = readTab((*tabs)->at(std::string(row.name)), row, workspace); !read)
            return read;
    }
    const auto front = objectIn(json, "front");
    if (!front)
        return fail(front.error());
    for (const DockRow& row : dockRows) {
        if (!*front || !(*front)->contains(row.name))
            continue;
        const WorkspaceJson& name = (*front)->at(std::string(row.name));
        if (!name.is_string())
            return fail(ErrorCode::Malformed,
                        fmt::format("expected the name of a tab, found {}", foundText(name)),
                        fmt::format("/front/{}", row.name));
        if (const TabRow* tab = rowNamed(tabRows, name)) // otherwise from another version
            workspace.front[static_cast<std::size_t>(row.dock)] = tab->tab;
    }
    return {};
}

Result<void> readSeams(const WorkspaceJson& json, Seams& seams) {
    const auto object = objectIn(json, "seams");
    if (!object)
        return fail(object.error());
    for (const SeamRow& row : seamRows) {
        if (!*object || !(*object)->contains(row.key))
            continue;
        const WorkspaceJson& value = (*object)->at(row.key);
        const float number = value.is_number() ? value.get<float>() : -1;
        if (!(number >= 0 && number <= row.max))
            return fail(ErrorCode::OutOfRange,
                        fmt::format("expected a number from 0 to {}, found {}", row.max, foundText(value)),
                        fmt::format("/seams/{}", row.key));
        seams.*row.member = number;
    }
    return {};
}

} // namespace

std::string writeWorkspace(const Workspace& workspace) {
    WorkspaceJson json;
    for (const ShownRow& row : shownRows)
        json[row.key] = workspace.*row.member;
    for (const TabRow& row : tabRows)
        json["tabs"][std::string(row.name)] = {
            {"dock", dockRows[static_cast<std::size_t>(dockOf(workspace, row.tab))].name},
            {"open", isOpen(workspace, row.tab)}};
    for (const DockRow& row : dockRows)
        json["front"][std::string(row.name)] =
            rowOf(workspace.front[static_cast<std::size_t>(row.dock)]).name;
    for (const SeamRow& row : seamRows)
        json["seams"][row.key] = workspace.seams.*row.member;
    return json.dump(2) + "\n";
}

Result<Workspace> parseWorkspace(std::string_view text) {
    const WorkspaceJson json = WorkspaceJson::parse(text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed,
                    json.is_discarded() ? std::string("expected a JSON object, found no JSON")
                                        : fmt::format("expected a JSON object, found {}", json.type_name()));
    Workspace workspace;
    for (const ShownRow& row : shownRows) {
        const auto shown = json.find(row.key);
        if (shown == json.end())
            continue;
        if (!shown->is_boolean())
            return fail(ErrorCode::Malformed,
                        fmt::format("expected true or false, found {}", foundText(*shown)),
                        fmt::format("/{}", row.key));
        workspace.*row.member = shown->get<bool>();
    }
    if (const auto read = readTabs(json, workspace); !read)
        return fail(read.error());
    if (const auto read = readSeams(json, workspace.seams); !read)
        return fail(read.error());
    return workspace;
}

} // namespace texplorer::ui

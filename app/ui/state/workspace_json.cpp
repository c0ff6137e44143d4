#include "app/ui/state/workspace.h"

#include <fmt/core.h>
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

/// A value, and its JSON pointer.
struct Place {
    const WorkspaceJson& value;
    std::string where{};
};

/// `words` end with a place for the value: hostile text may be deep or long.
template<class... Accepted>
Result<void> refuse(const Place& at, ErrorCode code, const char* words, const Accepted&... accepted) {
    constexpr std::size_t maxShown = 40;
    const std::string type = at.value.type_name();
    const std::string text = at.value.is_primitive() ? at.value.dump() : type;
    const std::string& found = text.size() > maxShown ? type : text;
    return fail(code, fmt::format(fmt::runtime(words), accepted..., found), at.where);
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

/// Reads the member of an object, if it has it.
template<class Read>
Result<void> readMember(const Place& object, std::string_view name, const Read& read) {
    if (!object.value.is_object())
        return refuse(object, ErrorCode::Malformed, "expected an object, found {}");
    const auto member = object.value.find(name);
    return member == object.value.end() ? Result<void>()
                                        : read(Place{*member, fmt::format("{}/{}", object.where, name)});
}

/// The same for each row's member.
template<class Rows, class Read>
Result<void> readMembers(const Place& object, const Rows& rows, const Read& read) {
    for (const auto& row : rows) {
        const auto readRow = [&](const Place& at) { return read(row, at); };
        if (Result<void> done = readMember(object, row.name, readRow); !done)
            return done;
    }
    return {};
}

Result<void> readSwitch(const Place& at, bool& isOn) {
    if (!at.value.is_boolean())
        return refuse(at, ErrorCode::Malformed, "expected true or false, found {}");
    isOn = at.value.get<bool>();
    return {};
}

Result<void> readDock(const Place& at, Dock& dock) {
    const DockRow* named = rowNamed(dockRows, at.value);
    if (!named)
        return refuse(at, ErrorCode::OutOfRange, "expected one of {}, found {}", workspaceNames(dockRows));
    dock = named->dock;
    return {};
}

Result<void> readTab(const Place& tab, TabPlace& place) {
    return readMember(tab, "dock", [&](const Place& at) { return readDock(at, place.dock); }).and_then([&] {
        return readMember(tab, "open", [&](const Place& at) { return readSwitch(at, place.open); });
    });
}

Result<void> readFront(const Place& at, Tab& front) {
    if (!at.value.is_string())
        return refuse(at, ErrorCode::Malformed, "expected the name of a tab, found {}");
    if (const TabRow* tab = rowNamed(tabRows, at.value)) // otherwise from another version
        front = tab->tab;
    return {};
}

Result<void> readSeam(const Place& at, float max, float& seam) {
    const float number = at.value.is_number() ? at.value.get<float>() : -1;
    if (!(number >= 0 && number <= max))
        return refuse(at, ErrorCode::OutOfRange, "expected a number from 0 to {}, found {}", max);
    seam = number;
    return {};
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
    for (const SeamRow& row : seamRows)
        json["seams"][std::string(row.name)] = workspace.seams.*row.member;
    return json.dump(2) + "\n";
}

Result<Workspace> parseWorkspace(std::string_view text) {
    const WorkspaceJson json = WorkspaceJson::parse(text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed,
                    json.is_discarded() ? std::string("expected a JSON object, found no JSON")
                                        : fmt::format("expected a JSON object, found {}", json.type_name()));
    Workspace workspace;
    const Place whole{json};
    const auto part = [&](std::string_view name, const auto& rows, const auto& read) {
        return readMember(whole, name, [&](const Place& at) { return readMembers(at, rows, read); });
    };
    const auto shown = [&](const ShownRow& row, const Place& at) {
        return readSwitch(at, workspace.*row.member);
    };
    const auto tab = [&](const TabRow& row, const Place& at) {
        return readTab(at, workspace.tabs[static_cast<std::size_t>(row.tab)]);
    };
    const auto front = [&](const DockRow& row, const Place& at) {
        return readFront(at, workspace.front[static_cast<std::size_t>(row.dock)]);
    };
    const auto seam = [&](const SeamRow& row, const Place& at) {
        return readSeam(at, row.max, workspace.seams.*row.member);
    };
    return readMembers(whole, shownRows, shown)
        .and_then([&] { return part("tabs", tabRows, tab); })
        .and_then([&] { return part("front", dockRows, front); })
        .and_then([&] { return part("seams", seamRows, seam); })
        .map([&] { return workspace; });
}

} // namespace texplorer::ui

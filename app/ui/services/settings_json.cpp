#include "app/ui/services/settings_json.h"

#include "texplorer/text/json_encoding.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace texplorer::ui {
namespace {

using SettingsJson = nlohmann::ordered_json;

constexpr std::size_t maxPinned = 1000;

/// A stored member. `read` returns whether it accepts the value.
struct SettingRow {
    const char* key;
    SettingsJson (*write)(const Settings& settings);
    bool (*read)(const SettingsJson& value, Settings& settings);
};

template<bool Settings::*member>
constexpr SettingRow switchRow(const char* key) {
    return {key, [](const Settings& settings) { return SettingsJson(settings.*member); },
            [](const SettingsJson& value, Settings& settings) {
                if (value.is_boolean())
                    settings.*member = value.get<bool>();
                return value.is_boolean();
            }};
}

/// A choice of one of these rows, stored by its name.
template<auto Settings::*member, const auto& rows, auto chosen>
constexpr SettingRow choiceRow(const char* key) {
    return {key,
            [](const Settings& settings) {
                return SettingsJson(std::ranges::find(rows, settings.*member, chosen)->name);
            },
            [](const SettingsJson& value, Settings& settings) {
                const auto row = std::ranges::find_if(
                    rows, [&](const auto& each) { return value.is_string() && value == each.name; });
                if (row != rows.end())
                    settings.*member = (*row).*chosen;
                return row != rows.end();
            }};
}

bool readTextPercent(const SettingsJson& value, Settings& settings) {
    if (!value.is_number_integer() || value < Settings::minText || value > Settings::maxText)
        return false;
    settings.textPercent = value.get<int>();
    return true;
}

bool readPinned(const SettingsJson& value, Settings& settings) {
    const auto isText = [](const SettingsJson& each) { return each.is_string(); };
    if (!value.is_array() || value.size() > maxPinned || !std::ranges::all_of(value, isText))
        return false;
    settings.pinned = value.get<std::vector<std::string>>();
    return true;
}

SettingsJson writeLessons(const Settings& settings) {
    SettingsJson lessons = SettingsJson::object();
    for (const auto& [name, records] : settings.lessons) {
        SettingsJson steps = SettingsJson::array();
        for (const StepRecord& record : records)
            steps.push_back({record.done, record.tries, record.answer});
        lessons[name] = std::move(steps);
    }
    return lessons;
}

bool readLessons(const SettingsJson& value, Settings& settings) {
    if (!value.is_object() || value.size() > maxLessonsKept)
        return false;
    std::map<std::string, std::vector<StepRecord>> lessons;
    for (const auto& [name, steps] : value.items()) {
        if (!steps.is_array() || steps.size() > maxStepsKept)
            return false;
        for (const SettingsJson& step : steps) {
            const auto isWithin = [](const SettingsJson& each, int min, int max) {
                return each.is_number_integer() && each >= min && each <= max;
            };
            if (!step.is_array() || step.size() != 3 || !step[0].is_boolean() ||
                !isWithin(step[1], 0, maxTriesKept) || !isWithin(step[2], -1, maxTriesKept))
                return false;
            lessons[name].push_back({step[0].get<bool>(), step[1].get<int>(), step[2].get<int>()});
        }
    }
    settings.lessons = std::move(lessons);
    return true;
}

bool readWorkspace(const SettingsJson& value, Settings& settings) {
    const std::optional<Workspace> workspace = parseWorkspace(value.dump());
    if (!workspace)
        return false;
    settings.workspace = *workspace;
    return true;
}

constexpr std::array settingRows{
    choiceRow<&Settings::theme, themeRows, &ThemeRow::theme>("theme"),
    choiceRow<&Settings::language, languageRows, &LanguageRow::language>("language"),
    SettingRow{"textPercent", [](const Settings& settings) { return SettingsJson(settings.textPercent); },
               readTextPercent},
    switchRow<&Settings::largeControls>("largeControls"),
    switchRow<&Settings::glNames>("glNames"),
    switchRow<&Settings::helpBelow>("helpBelow"),
    switchRow<&Settings::hasSeenTour>("hasSeenTour"),
    SettingRow{"pinned", [](const Settings& settings) { return SettingsJson(settings.pinned); }, readPinned},
    SettingRow{"lessons", writeLessons, readLessons},
    SettingRow{
        "workspace",
        [](const Settings& settings) { return SettingsJson::parse(writeWorkspace(settings.workspace)); },
        readWorkspace},
};

Result<SettingsJson> parseText(std::string_view json) {
    if (const Result<void> whole = checkEncoding(json); !whole)
        return fail(whole.error());
    constexpr int maxDepth = 32; // nlohmann-json writes recursively
    bool isTooDeep = false;
    SettingsJson value = SettingsJson::parse(
        json,
        [&isTooDeep](int depth, SettingsJson::parse_event_t, const SettingsJson&) {
            isTooDeep = isTooDeep || depth > maxDepth;
            return !isTooDeep;
        },
        false);
    if (isTooDeep)
        return fail(ErrorCode::TooLarge, Sentence("expected at most {0} levels of brackets", maxDepth));
    if (value.is_discarded())
        return fail(ErrorCode::Malformed, "expected JSON");
    return value;
}

Result<SettingsJson> parseObject(std::string_view json) {
    Result<SettingsJson> object = parseText(json);
    if (object && !object->is_object())
        return fail(ErrorCode::Malformed, "expected an object");
    return object;
}

/// A value without its unknown members; none: all of it is unknown. A list within an object is known as a
/// whole or not at all, since the positions in it have a meaning.
std::optional<SettingsJson> knownPart(const SettingsJson& value,
                                      const std::function<bool(const SettingsJson&)>& isKnown,
                                      const SettingsJson::json_pointer& where,
                                      std::vector<std::string>& leftOut, bool isMember = false) {
    if (isKnown(value))
        return value;
    if (value.is_object()) {
        SettingsJson known = SettingsJson::object();
        for (const auto& [key, member] : value.items()) {
            const auto isKnownMember = [&isKnown, &name = key](const SettingsJson& part) {
                return isKnown(SettingsJson::object({{name, part}}));
            };
            if (auto part = knownPart(member, isKnownMember, where / key, leftOut, true))
                known[key] = *std::move(part);
        }
        if (isKnown(known))
            return known;
    } else if (value.is_array() && !isMember) {
        SettingsJson known = SettingsJson::array();
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (isKnown(SettingsJson::array({value[i]})))
                known.push_back(value[i]);
            else
                leftOut.push_back((where / i).to_string());
        }
        if (isKnown(known))
            return known;
    }
    leftOut.push_back(where.to_string());
    return std::nullopt;
}

std::string settingsText(const SettingsJson& value) {
    return value.dump(4, ' ', false, SettingsJson::error_handler_t::replace) + '\n';
}

} // namespace

std::string writeSettings(const Settings& settings, std::string_view before) {
    const Result<SettingsJson> parsed = parseText(before);
    SettingsJson object = parsed && parsed->is_object() ? *parsed : SettingsJson::object();
    for (const SettingRow& row : settingRows)
        object[row.key] = row.write(settings);
    return settingsText(object);
}

Result<Settings> parseSettings(std::string_view json, std::vector<std::string>& leftOut) {
    const Result<SettingsJson> object = parseObject(json);
    if (!object)
        return fail(object.error());
    Settings settings;
    for (const SettingRow& row : settingRows) {
        const auto value = object->find(row.key);
        if (value == object->end())
            continue;
        const auto isKnown = [&row](const SettingsJson& part) {
            Settings ignored;
            return row.read(part, ignored);
        };
        if (const std::optional<SettingsJson> known =
                knownPart(*value, isKnown, SettingsJson::json_pointer() / row.key, leftOut))
            row.read(*known, settings);
    }
    return settings;
}

std::string writeRecentFiles(const Settings& settings) {
    SettingsJson list = SettingsJson::array();
    for (const std::filesystem::path& file : settings.recentFiles)
        list.push_back(file.string());
    return settingsText(list);
}

Result<std::vector<std::filesystem::path>> parseRecentFiles(std::string_view json,
                                                            std::vector<std::string>& leftOut) {
    const Result<SettingsJson> list = parseText(json);
    if (!list)
        return fail(list.error());
    if (!list->is_array())
        return fail(ErrorCode::Malformed, "expected a list of files");
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const SettingsJson& each = (*list)[i];
        if (!each.is_string())
            leftOut.push_back(fmt::format("/{}", i));
        else if (files.size() < maxRecentFiles)
            files.emplace_back(each.get<std::string>());
    }
    return files;
}

} // namespace texplorer::ui

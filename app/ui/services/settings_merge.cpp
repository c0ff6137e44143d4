#include "app/ui/services/settings_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::ui {
namespace {

using MergedJson = nlohmann::ordered_json;

template<class Each>
bool has(const std::vector<Each>& list, const Each& wanted) {
    return std::ranges::find(list, wanted) != list.end();
}

/// With the added elements and without the removed ones.
std::vector<std::string> mergeLists(std::vector<std::string> list, const std::vector<std::string>& before,
                                    const std::vector<std::string>& now) {
    std::erase_if(list, [&](const std::string& each) { return has(before, each) && !has(now, each); });
    for (const std::string& each : now) {
        if (!has(before, each) && !has(list, each))
            list.push_back(each);
    }
    return list;
}

/// How many of the first ones were opened since: the others are in the old order.
std::size_t countOfOpened(const std::vector<std::filesystem::path>& before,
                          const std::vector<std::filesystem::path>& now) {
    std::size_t opened = now.size();
    auto last = before.end();
    while (opened > 0) {
        const auto found = std::find(before.begin(), last, now[opened - 1]);
        if (found == last)
            break;
        last = found;
        --opened;
    }
    return opened;
}

} // namespace

std::string mergeSettings(std::string_view file, const Settings& before, const Settings& now) {
    std::vector<std::string> ignored; // unknown values stay in the file
    const Result<Settings> there = file.empty() ? Result<Settings>(before) : parseSettings(file, ignored);
    Settings mine = now;
    if (there)
        mine.pinned = mergeLists(there->pinned, before.pinned, now.pinned);
    const MergedJson old = MergedJson::parse(writeSettings(before));
    const MergedJson wanted = MergedJson::parse(writeSettings(mine));
    MergedJson merged = MergedJson::parse(file, nullptr, false);
    if (!merged.is_object())
        merged = MergedJson::object();
    for (const auto& [key, value] : wanted.items()) {
        if (!merged.contains(key) || old.at(key) != value)
            merged[key] = value;
    }
    return merged.dump(4, ' ', false, MergedJson::error_handler_t::replace) + '\n';
}

std::vector<std::filesystem::path> mergeRecentFiles(const std::vector<std::filesystem::path>& file,
                                                    const std::vector<std::filesystem::path>& before,
                                                    const std::vector<std::filesystem::path>& now) {
    const std::size_t opened = countOfOpened(before, now);
    std::vector<std::filesystem::path> merged(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(opened));
    for (const std::filesystem::path& each : file) {
        const bool isForgotten = has(before, each) && !has(now, each);
        if (!isForgotten && !has(merged, each) && merged.size() < maxRecentFiles)
            merged.push_back(each);
    }
    return merged;
}

} // namespace texplorer::ui

#include "app/ui/model/settings_file.h"

#include "core/base/file_io.h"
#include "core/base/user_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestSettings = std::size_t{1} << 20;
constexpr FailureWords settingsFailure{"there is no memory for the settings", "the settings can't be kept"};

fs::path placeIn(const fs::path& folder, const char* name) {
    return folder.empty() ? folder : folder / "texplorer" / name;
}

std::string settingsProblem(const Error& error) {
    return fmt::format("Settings can't be kept: {}.", describe(error));
}

/// Empty: it is written.
std::string putSettings(const fs::path& file, const std::string& text) {
    std::error_code ignored; // the writing says what is wrong
    fs::create_directories(file.parent_path(), ignored);
    const Result<void> written = writeFileAtomically(file, viewBytes(text));
    return written ? std::string() : settingsProblem(written.error());
}

/// A file that is there and can't be understood gets another name, so that nothing writes over it.
std::string setAside(const fs::path& file, const Error& error) {
    fs::path broken = file;
    broken += ".broken";
    std::error_code failed;
    fs::rename(file, broken, failed);
    return failed ? fmt::format("{} can't be read ({}).", file.string(), describe(error))
                  : fmt::format("{} can't be read ({}). It was set aside as {}.", file.string(),
                                describe(error), broken.filename().string());
}

} // namespace

void rememberFile(Settings& settings, const fs::path& file) {
    if (file.empty())
        return;
    std::erase(settings.recentFiles, file);
    settings.recentFiles.insert(settings.recentFiles.begin(), file);
    if (settings.recentFiles.size() > mostRecentFiles)
        settings.recentFiles.resize(mostRecentFiles);
}

SettingsPlaces SettingsPlaces::ofUser() {
    return {placeIn(userFolder("XDG_CONFIG_HOME", ".config"), "settings.json"),
            placeIn(userFolder("XDG_STATE_HOME", ".local/state"), "recent.json")};
}

SettingsFile::SettingsFile(SettingsPlaces places, std::function<void()> wake, std::chrono::milliseconds delay,
                           Clock clock)
    : places_(std::move(places))
    , delay_(std::chrono::duration<double>(delay).count())
    , clock_(std::move(clock))
    , writing_(
          {When::WhenReady, JobOrder::Queue, settingsFailure, std::move(wake)},
          [](const Writing::Task& task) { return putSettings(task.job().file, task.job().text); },
          [](const Job& /*job*/, const Error& error) { return settingsProblem(error); }) {}

SettingsFile::~SettingsFile() {
    if (due_)
        write();
    writing_.wait();
}

Settings SettingsFile::read() {
    std::error_code ignored;
    const auto textOf = [&](const fs::path& file) {
        const bool isThere = !file.empty() && fs::exists(file, ignored);
        return isThere ? readText(file, longestSettings) : Result<std::string>(std::string());
    };
    const auto understand = [&](const fs::path& file, std::string& text, const auto& parse) {
        Result<std::string> found = textOf(file);
        if (found && found->empty())
            return;
        Result<void> parsed = found ? parse(*found) : Result<void>(fail(found.error()));
        if (parsed)
            text = std::move(*found);
        else
            problem_ = setAside(file, parsed.error());
    };
    understand(places_.settings, text_, [&](const std::string& text) {
        return parseSettings(text).map([&](Settings settings) { told_ = std::move(settings); });
    });
    understand(places_.recent, recent_, [&](const std::string& text) {
        return parseRecentFiles(text).map(
            [&](std::vector<fs::path> files) { told_.recentFiles = std::move(files); });
    });
    return told_;
}

void SettingsFile::keep(const Settings& settings) {
    if (settings != told_) {
        told_ = settings;
        if (!due_)
            due_ = clock_() + delay_;
    }
    if (due_ && clock_() >= *due_)
        write();
}

void SettingsFile::write() {
    due_.reset();
    const auto update = [this](const fs::path& file, std::string& before, std::string text) {
        if (file.empty() || text == before)
            return;
        before = std::move(text);
        writing_.ask({file, before});
    };
    update(places_.settings, text_, writeSettings(told_, text_));
    update(places_.recent, recent_, writeRecentFiles(told_));
}

std::optional<std::string> SettingsFile::takeProblem() {
    for (std::string& each : writing_.take()) {
        if (!each.empty())
            problem_ = std::move(each);
    }
    return std::exchange(problem_, std::nullopt);
}

} // namespace texplorer::ui

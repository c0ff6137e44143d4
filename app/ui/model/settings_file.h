#pragma once

#include "app/ui/model/settings.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/base/worker.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Settings as JSON, an object; files that were opened are a text of their own. What `before` has under keys
/// that nobody knows is written again.
[[nodiscard]] std::string writeSettings(const Settings& settings, std::string_view before = {});
[[nodiscard]] std::string writeRecentFiles(const Settings& settings);

/// What the text leaves out is as in `Settings{}`; keys that nobody knows are left alone. Refused, with the
/// JSON pointer in Error::where: what is no JSON, wrong types, names and sizes that there aren't.
[[nodiscard]] Result<Settings> parseSettings(std::string_view json);
[[nodiscard]] Result<std::vector<std::filesystem::path>> parseRecentFiles(std::string_view json);

/// The same, but a value that can't be understood is left out, and its JSON pointer goes into `leftOut`: it
/// may be one of a later version. What is no JSON, or another document, is refused.
[[nodiscard]] Result<Settings> parseKnownSettings(std::string_view json, std::vector<std::string>& leftOut);
[[nodiscard]] Result<std::vector<std::filesystem::path>> parseKnownFiles(std::string_view json,
                                                                         std::vector<std::string>& leftOut);

inline constexpr std::size_t mostRecentFiles = 12;

/// To be called when a file was opened or saved: it comes first.
void rememberFile(Settings& settings, const std::filesystem::path& file);

/// Where they lie.
struct SettingsPlaces {
    std::filesystem::path settings; ///< empty: they are not kept
    std::filesystem::path recent;   ///< likewise

    /// $XDG_CONFIG_HOME/texplorer/settings.json and $XDG_STATE_HOME/texplorer/recent.json, else below
    /// ~/.config and ~/.local/state.
    [[nodiscard]] static SettingsPlaces ofUser();
};

/// Keeps settings on the disk: a moment after they have changed, and at the end. Another window may have
/// written since they were read: what this one changed goes into what lies there, see settings_merge.h.
/// Writes on a thread of its own where there is one to be had. The host makes one and lends it to the
/// session.
class SettingsFile {
public:
    static constexpr std::chrono::milliseconds usualDelay{1000};

    explicit SettingsFile(SettingsPlaces places, std::function<void()> wake = {},
                          std::chrono::milliseconds delay = usualDelay, Clock clock = steadySeconds);
    SettingsFile(const SettingsFile&) = delete;
    SettingsFile& operator=(const SettingsFile&) = delete;
    /// Writes what waits.
    ~SettingsFile();

    /// To be called once, at the start. A value that can't be understood is left out. A file that is no JSON
    /// is set aside, as "settings.json.broken", or where that is taken "settings.json.broken-2", and so on.
    [[nodiscard]] Settings read();

    /// These are the settings now. Costs a comparison where they are those of before.
    void keep(const Settings& settings);

    /// When `keep` has to be called again: something waits to be written. Nothing: it need not.
    [[nodiscard]] std::optional<double> due() const { return due_; }

    /// What there is to say to the user: once.
    [[nodiscard]] std::optional<std::string> takeProblem();

private:
    /// What was to be written since the last time.
    struct Job {
        SettingsPlaces places;
        Settings before;
        Settings now;
    };
    struct Answer {
        Settings before;
        std::string problem; ///< empty: it is written
    };
    using Writing = Worker<Job, Answer>;
    void learn();
    void write(); ///< one job at a time: the next one begins with what that one left

    SettingsPlaces places_;
    double delay_;
    Clock clock_;
    Settings told_;
    Settings written_; ///< what was read, or was to be written last
    std::optional<double> due_;
    std::optional<std::string> problem_;
    Writing writing_;
};

} // namespace texplorer::ui

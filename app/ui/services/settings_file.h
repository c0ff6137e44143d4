#pragma once

#include "app/ui/state/settings.h"
#include "texplorer/base/clock.h"
#include "texplorer/base/result.h"
#include "texplorer/base/worker.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

namespace texplorer::ui {

/// Call when a file was opened or saved: moves it to the front.
void rememberFile(Settings& settings, const std::filesystem::path& file);

/// The paths of the files.
struct SettingsPlaces {
    std::filesystem::path settings; ///< empty: they are not kept
    std::filesystem::path recent;   ///< empty: they are not kept

    /// $XDG_CONFIG_HOME/texplorer/settings.json and $XDG_STATE_HOME/texplorer/recent.json, else below
    /// ~/.config and ~/.local/state.
    [[nodiscard]] static SettingsPlaces ofUser();
};

/// Keeps settings on the disk: written shortly after a change, and at the end. If another window has written
/// since they were read, only the changes of this one are merged into the file, see settings_json.h. Writes
/// on its own thread if one is available. Owned by the host; must outlive the session.
class SettingsFile {
public:
    static constexpr std::chrono::milliseconds usualDelay{1000};

    explicit SettingsFile(SettingsPlaces places, std::function<void()> wake = {},
                          std::chrono::milliseconds delay = usualDelay, Clock clock = steadySeconds);
    SettingsFile(const SettingsFile&) = delete;
    SettingsFile& operator=(const SettingsFile&) = delete;
    /// Writes pending changes.
    ~SettingsFile();

    /// Call once, at the start. Skips invalid values. A file that is not JSON is renamed to
    /// "settings.json.broken", or, if that exists, "settings.json.broken-2", and so on. One that can't be
    /// read stays, and isn't written.
    [[nodiscard]] Settings read();

    /// Sets the current settings. Costs one comparison if they have not changed.
    void keep(const Settings& settings);

    /// When `keep` must be called again to write changes. Nothing: not needed.
    [[nodiscard]] std::optional<double> due() const { return due_; }

    /// A message for the user, once.
    [[nodiscard]] std::optional<Sentence> takeProblem();

private:
    /// The changes since the last write.
    struct Job {
        SettingsPlaces places;
        Settings before;
        Settings now;
    };
    struct Answer {
        Settings before;
        Sentence problem; ///< empty: written
    };
    using Writing = Worker<Job, Answer>;
    void learn();
    void write(); ///< one job at a time: the next one starts from its result

    SettingsPlaces places_;
    double delay_;
    Clock clock_;
    Settings told_;
    Settings written_; ///< what was read or last written
    std::optional<double> due_;
    std::optional<Sentence> problem_;
    Writing writing_;
};

} // namespace texplorer::ui

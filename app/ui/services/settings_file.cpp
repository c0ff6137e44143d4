#include "app/ui/services/settings_file.h"

#include "app/ui/services/settings_json.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/folder_lock.h"
#include "texplorer/files/user_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxSettingsBytes = std::size_t{1} << 20;
constexpr FailureWords settingsFailure{N_("not enough memory for the settings"),
                                       N_("the settings can't be saved")};

fs::path placeIn(const fs::path& folder, const char* name) {
    return folder.empty() ? folder : folder / "texplorer" / name;
}

Sentence cannotBeSaved(const Error& error) {
    return Sentence("Settings can't be saved: {0}.", describe(error));
}

Sentence cannotBeRead(const Error& error) {
    return Sentence("Settings can't be read: {0}.", describe(error));
}

/// Adds a sentence.
void addTo(Sentence& problem, const Sentence& sentence) {
    if (!sentence.empty())
        problem = problem.empty() ? sentence : Sentence("{0} {1}", problem, sentence);
}

/// Renames an existing file that cannot be parsed, so that it is not overwritten, without overwriting an
/// earlier renamed one.
Sentence setAside(const fs::path& file, const Error& error) {
    std::error_code failed;
    fs::path broken = file;
    broken += ".broken";
    for (int number = 2; fs::exists(fs::symlink_status(broken, failed)); ++number)
        broken = fmt::format("{}.broken-{}", file.string(), number);
    fs::rename(file, broken, failed);
    return failed ? Sentence("{0} can't be read ({1}).", ProperName{file.string()}, describe(error))
                  : Sentence("{0} can't be read ({1}). It was renamed to {2}.", ProperName{file.string()},
                             describe(error), ProperName{broken.filename().string()});
}

Sentence leftOutText(const fs::path& file, const std::vector<std::string>& leftOut) {
    if (leftOut.empty())
        return {};
    return Sentence("{0} has unknown values, which are ignored: {1}.", ProperName{file.string()},
                    ProperName{fmt::format("{}", fmt::join(leftOut, ", "))});
}

/// Empty if there is no file, or if it cannot be parsed and was renamed: then `problem` says so. Errors:
/// those of readText; the file is left as it is.
template<class Parse>
Result<std::string> readWhole(const fs::path& file, const Parse& parse, Sentence& problem) {
    std::error_code ignored;
    if (file.empty() || !fs::exists(file, ignored))
        return {};
    Result<std::string> text = readText(file, maxSettingsBytes);
    if (!text || text->empty())
        return text;
    const Result<void> parsed = parse(*text);
    if (parsed)
        return text;
    addTo(problem, setAside(file, parsed.error()));
    return {};
}

/// For `readWhole`.
auto settingsInto(Settings& settings, std::vector<std::string>& leftOut) {
    return [&](const std::string& text) {
        return parseSettings(text, leftOut).map([&](Settings read) { settings = std::move(read); });
    };
}

auto recentInto(std::vector<fs::path>& files) {
    return [&](const std::string& text) {
        std::vector<std::string> ignored; // lost recent files do not matter
        return parseRecentFiles(text, ignored).map([&](std::vector<fs::path> read) {
            files = std::move(read);
        });
    };
}

/// Reads one of the files again and writes it if it changes. Returns an error message, or an empty text.
template<class Parse, class Merge>
Sentence mergeInto(const fs::path& file, const Parse& parse, const Merge& merge) {
    std::error_code ignored; // reported by writing
    fs::create_directories(file.parent_path(), ignored);
    const FolderLock lock(
        file.parent_path()); // otherwise a simultaneous change of another window could be lost
    Sentence problem;
    const Result<std::string> there = readWhole(file, parse, problem);
    if (!there)
        return cannotBeSaved(there.error());
    const std::string text = merge(*there);
    if (file.empty() || text == *there)
        return problem;
    const Result<void> written = writeFileAtomically(file, viewBytes(text));
    return written ? problem : cannotBeSaved(written.error());
}

Sentence writeChanges(const SettingsPlaces& places, const Settings& before, const Settings& now) {
    Sentence problem;
    Settings found;
    std::vector<std::string> ignored; // they stay in the file
    if (writeSettings(before) != writeSettings(now))
        problem = mergeInto(places.settings, settingsInto(found, ignored),
                            [&](const std::string& there) { return mergeSettings(there, before, now); });
    if (before.recentFiles == now.recentFiles)
        return problem;
    found.recentFiles = before.recentFiles; // if there is no file
    addTo(problem, mergeInto(places.recent, recentInto(found.recentFiles), [&](const std::string&) {
              found.recentFiles = mergeRecentFiles(found.recentFiles, before.recentFiles, now.recentFiles);
              return writeRecentFiles(found);
          }));
    return problem;
}

} // namespace

void rememberFile(Settings& settings, const fs::path& file) {
    if (file.empty())
        return;
    std::erase(settings.recentFiles, file);
    settings.recentFiles.insert(settings.recentFiles.begin(), file);
    if (settings.recentFiles.size() > maxRecentFiles)
        settings.recentFiles.resize(maxRecentFiles);
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
          [](const Writing::Task& task) {
              const Job& job = task.job();
              return Answer{job.before, writeChanges(job.places, job.before, job.now)};
          },
          [](const Job& job, const Error& error) {
              return Answer{job.before, cannotBeSaved(error)};
          }) {}

SettingsFile::~SettingsFile() {
    writing_.wait();
    learn();
    write(); // writes what is not written yet
    writing_.wait();
}

Settings SettingsFile::read() {
    Sentence problem;
    std::vector<std::string> leftOut;
    const Result<std::string> settings = readWhole(places_.settings, settingsInto(told_, leftOut), problem);
    addTo(problem, settings ? leftOutText(places_.settings, leftOut) : cannotBeRead(settings.error()));
    const Result<std::string> recent = readWhole(places_.recent, recentInto(told_.recentFiles), problem);
    if (!recent)
        addTo(problem, cannotBeRead(recent.error()));
    if (!problem.empty())
        problem_ = std::move(problem);
    written_ = told_;
    return told_;
}

void SettingsFile::keep(const Settings& settings) {
    if (settings != told_) {
        told_ = settings;
        if (!due_)
            due_ = clock_() + delay_;
    }
    if (!due_ || clock_() < *due_)
        return;
    if (writing_.isWorking()) // its answer decides what is left to write
        due_ = clock_() + delay_;
    else
        write();
}

void SettingsFile::learn() {
    for (Answer& each : writing_.take()) {
        if (each.problem.empty())
            continue;
        written_ = std::move(each.before); // so that it is tried again
        problem_ = std::move(each.problem);
    }
}

void SettingsFile::write() {
    due_.reset();
    learn();
    if (written_ == told_)
        return;
    writing_.ask({places_, std::exchange(written_, told_), told_});
}

std::optional<Sentence> SettingsFile::takeProblem() {
    learn();
    return std::exchange(problem_, std::nullopt);
}

} // namespace texplorer::ui

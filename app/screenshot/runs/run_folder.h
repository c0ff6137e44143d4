#pragma once

// The folder of a run: its journal while it lasts, its report in the end.

#include "app/screenshot/arguments/outputs_apart.h"
#include "texplorer/base/result.h"
#include "texplorer/files/descriptor.h"
#include "texplorer/suite/record.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace texplorer::screenshot {

inline constexpr const char* journalName = "journal.jsonl";
inline constexpr const char* recordName = "run.json";

/// What a run writes into its folder.
[[nodiscard]] std::vector<NamedOutput> outputsOfRunFolder(const char* option,
                                                          const std::filesystem::path& folder);

/// Keeps other runs out while it lives. What it writes are files of these names, of a report's page, and
/// within "pictures/"; whatever else lies there stays.
class RunFolder {
public:
    /// Made where it is missing. Errors: it can't be made or written to; another run has it; it has files of
    /// these names, and no run has left them: an empty journal doesn't say that one has.
    [[nodiscard]] static Result<RunFolder> open(const std::filesystem::path& path);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// What an interrupted run of the same cases has done: records by their cases' names. The error says why
    /// it can't be gone on with.
    [[nodiscard]] Result<std::map<std::string, suite::CaseRecord>> resume(const suite::RunRecord& run);
    /// Begins anew: what another run has left is removed.
    [[nodiscard]] Result<void> begin(const suite::RunRecord& run);

    /// After either of them. It is in the file, whatever becomes of this process, when this returns.
    [[nodiscard]] Result<void> add(const suite::CaseRecord& record);

    /// The report: run.json and the page.
    [[nodiscard]] Result<void> finish(const suite::RunRecord& run, const std::string& acceptCommand) const;

private:
    explicit RunFolder(std::filesystem::path path, Descriptor lock)
        : path_(std::move(path))
        , lock_(std::move(lock)) {}

    [[nodiscard]] Result<void> openJournal();
    [[nodiscard]] Result<void> append(const std::string& line);
    [[nodiscard]] std::string journalPath() const { return (path_ / journalName).string(); }

    std::filesystem::path path_;
    Descriptor lock_;
    Descriptor journal_;
};

} // namespace texplorer::screenshot

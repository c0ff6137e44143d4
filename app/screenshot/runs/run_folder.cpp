#include "app/screenshot/runs/run_folder.h"

#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/runs/case_pictures.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/files/file_lock.h"
#include "texplorer/report/report_files.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/run_page.h"

#include <fcntl.h>
#include <optional>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

Error cantWrite(const std::string& path) {
    return {ErrorCode::Unwritable, Sentence("can't be written: {0}", systemText(errno)), inFile(path)};
}

bool isRecordOfOurs(const fs::path& folder) {
    const Result<std::string> record = readText((folder / recordName).string(), suite::maxRecordBytes);
    if (record && suite::parseRun(*record))
        return true;
    const Result<std::string> journal = readText((folder / journalName).string(), suite::maxRecordBytes);
    return journal && suite::parseJournal(*journal);
}

/// What a report replaces or removes must be a report's.
Result<void> checkOurs(const fs::path& folder) {
    std::error_code ignored;
    std::vector<std::string> names = report::pageFileNames();
    names.insert(names.end(), {recordName, journalName, picturesFolder});
    for (const std::string& name : names) {
        const fs::file_status status = fs::symlink_status(folder / name, ignored);
        const bool mayBeEmpty =
            fs::is_directory(status) || (name == journalName && fs::is_regular_file(status));
        if (!fs::exists(status) || (mayBeEmpty && fs::is_empty(folder / name, ignored)))
            continue; // as a run leaves it that couldn't begin
        if (isRecordOfOurs(folder))
            return {};
        return fail(ErrorCode::Unwritable,
                    Sentence("expected a new folder or one with a report of texshot test, found \"{0}\" of "
                             "something else",
                             name),
                    inFile(folder.string()));
    }
    return {};
}

} // namespace

std::vector<NamedOutput> outputsOfRunFolder(const char* option, const fs::path& folder) {
    std::vector<NamedOutput> outputs{{option, (folder / picturesFolder).string(), true}};
    for (const std::string& name : report::pageFileNames())
        outputs.push_back({option, (folder / name).string()});
    for (const char* name : {recordName, journalName})
        outputs.push_back({option, (folder / name).string()});
    return outputs;
}

Result<RunFolder> RunFolder::open(const fs::path& path) {
    if (const Result<void> ours = checkOurs(path); !ours)
        return fail(ours.error());
    std::error_code error;
    fs::create_directories(path, error);
    if (error)
        return fail(ErrorCode::Unwritable, Sentence("the folder can't be made: {0}", error.message()),
                    inFile(path.string()));
    if (const Result<void> writable = checkFolderWritable(path); !writable)
        return fail(writable.error());
    const fs::path pictures = path / picturesFolder;
    if (::mkdir(pictures.c_str(), 0777) != 0 && errno != EEXIST)
        return fail(cantWrite(pictures.string()));
    struct stat info {};
    if (::lstat(pictures.c_str(), &info) != 0 || !S_ISDIR(info.st_mode))
        return fail(ErrorCode::Unwritable, "expected a folder for pictures, found something else",
                    inFile(pictures.string()));
    // A file system without locks has to do without this one.
    Descriptor lock(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lockFile(lock.get()) == EWOULDBLOCK)
        return fail(ErrorCode::Unwritable, "another run writes its report there", inFile(path.string()));
    return RunFolder(path, std::move(lock));
}

Result<void> RunFolder::openJournal() {
    journal_ = Descriptor(
        ::open(journalPath().c_str(),
               O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY, 0666));
    struct stat info {};
    if (!journal_.valid() || ::fstat(journal_.get(), &info) != 0)
        return fail(cantWrite(journalPath()));
    if (!S_ISREG(info.st_mode))
        return fail(ErrorCode::Unwritable, "expected a file, found a device, pipe or folder",
                    inFile(journalPath()));
    return {};
}

Result<void> RunFolder::append(const std::string& line) {
    outputBegins();
    if (!writeFully(journal_.get(), viewBytes(line)))
        return fail(cantWrite(journalPath()));
    return {};
}

Result<std::map<std::string, suite::CaseRecord>> RunFolder::resume(const suite::RunRecord& run) {
    const Result<std::string> text = readText(journalPath(), suite::maxRecordBytes);
    if (!text)
        return fail(text.error());
    Result<suite::Journal> journal = suite::parseJournal(*text);
    if (!journal)
        return fail(within(inFile(journalPath()), journal.error()));
    if (const Result<void> same = checkResumable(journal->run, run); !same)
        return fail(same.error().code, same.error().message, inFile(journalPath()));
    if (const Result<void> opened = openJournal(); !opened)
        return fail(opened.error());
    if (::ftruncate(journal_.get(), static_cast<off_t>(journal->wholeBytes)) != 0)
        return fail(cantWrite(journalPath()));
    std::map<std::string, suite::CaseRecord> records;
    for (suite::CaseRecord& each : journal->run.cases) {
        std::string name = each.name;
        records.insert_or_assign(std::move(name), std::move(each));
    }
    return records;
}

Result<void> RunFolder::begin(const suite::RunRecord& run) {
    // At no moment is the journal empty: it says that all the rest is a run's.
    if (const Result<void> opened = openJournal(); !opened)
        return opened;
    const std::string start = suite::journalStart(run);
    if (const Result<void> begun = writeFileAtomically(journalPath(), viewBytes(start)); !begun)
        return begun;
    if (const Result<void> opened = openJournal(); !opened)
        return opened;
    outputBegins();
    removePictures(path_);
    for (const char* old : {recordName, "index.html"}) { // of a run that isn't this one
        std::error_code ignored;
        fs::remove(path_ / old, ignored);
    }
    return {};
}

Result<void> RunFolder::add(const suite::CaseRecord& record) {
    return append(suite::journalLine(record));
}

Result<void> RunFolder::finish(const suite::RunRecord& run, const std::string& acceptCommand) const {
    const Result<std::vector<report::File>> files =
        report::filesOf(suite::pageOf(run, {.acceptCommand = acceptCommand}));
    if (!files)
        return fail(files.error());
    const std::string record = suite::asJson(run);
    std::vector<FileContent> contents{{recordName, viewBytes(record)}};
    for (const report::File& each : *files)
        contents.push_back({each.name, each.bytes});
    std::optional<Uninterrupted> placing;
    return writeFolderAtomically(path_, contents, [&placing] { placing.emplace(); });
}

} // namespace texplorer::screenshot

#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/worker.h"
#include "texplorer/files/file_fingerprint.h"
#include "texplorer/texture/texture_levels.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// The means for making a file's bytes.
struct FileMaking {
    unsigned threads = 1;                      ///< the maximum number of threads
    LevelWork levels{};                        ///< how textures are made; its `stop` ends the whole work
    std::function<void(float share)> report{}; ///< 0 to 1: reports the progress
};

struct MadeFile {
    Bytes bytes;
    Sentence remark{}; ///< a sentence about differences from the request; empty: none
};

/// A file that is to be written.
struct FileOrder {
    std::filesystem::path file;      ///< is written completely or stays unchanged
    Sentence::Key<Sentence> failure; ///< "The sheet can't be written: {0}."
    std::size_t pictures = 0;        ///< pictures to draw; 0: the file has no pictures
    /// Runs on the working thread. Errors become a sentence with `failure`, except Cancelled.
    std::function<Result<MadeFile>(const FileMaking&)> make;
    /// The file that the user has agreed to replace. If another file is there by then, it stays, and this
    /// file gets a free name.
    std::optional<FileFingerprint> replaces{};
};

/// The progress of a file.
struct FileProgress {
    std::filesystem::path file;
    std::size_t pictures = 0; ///< pictures to draw; 0: the file has no pictures
    float share = 0;          ///< 0 to 1

    [[nodiscard]] std::size_t picturesDrawn() const;
};

/// A sentence for the user.
struct FileNews {
    Sentence text;
    bool isGood = false; ///< written completely as requested
};

/// Writes files that take long to make, one after the other, in the background; at its end those that are not
/// written yet are cancelled. Call all functions on one thread. A host without threads or folders overrides
/// the virtual functions.
class FileWriting {
public:
    /// `wake` is called on the working thread when there is a result. `levels`: how textures are compressed
    /// at run time.
    explicit FileWriting(When when, std::function<void()> wake = {}, LevelWork levels = {});
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;
    virtual ~FileWriting() = default;

    virtual void write(FileOrder order);
    /// The same for a file that the user has named, see FileOrder::replaces. Errors: its name does not end
    /// with `extension`.
    [[nodiscard]] Result<void> writeAs(FileOrder order, std::string_view extension,
                                       const std::optional<FileFingerprint>& replaces);
    /// The progress of the current file; nothing if there is none.
    [[nodiscard]] virtual std::optional<FileProgress> progress() const { return worker_.progress(); }
    /// Cancels all files that are not written yet: the old ones stay unchanged.
    virtual void cancel() {
        worker_.drop([](const FileOrder&) { return true; });
    }
    /// The result, once: of the first file that failed, or of the last one that was written.
    [[nodiscard]] std::optional<FileNews> takeNews();
    /// Blocks until all files are written.
    void wait() const { worker_.wait(); }

protected:
    /// The results since the last call.
    [[nodiscard]] virtual std::vector<FileNews> take() { return worker_.take(); }
    /// Writes what was made.
    [[nodiscard]] FileNews finish(const FileOrder& order, Result<MadeFile> made);
    /// Writes the bytes, and returns where.
    [[nodiscard]] virtual Result<std::filesystem::path> put(const FileOrder& order, ByteView bytes);

private:
    using Writing = Worker<FileOrder, FileNews, FileProgress>;
    [[nodiscard]] std::optional<FileNews> work(const Writing::Task& task);

    const LevelWork levels_;
    /// The files that it has written, which a later order of the same name replaces. Used only on the working
    /// thread.
    std::map<std::filesystem::path, FileFingerprint> own_;
    Writing worker_; // last member: it ends before the others
};

} // namespace texplorer::ui

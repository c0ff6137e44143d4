#pragma once

#include "core/base/bytes.h"
#include "core/base/file_fingerprint.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/texture/texture_levels.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// What whoever makes a file's bytes is lent.
struct FileMaking {
    unsigned threads = 1;                      ///< so many may work at it
    LevelWork levels{};                        ///< how textures are made; its `stop` ends all of the work
    std::function<void(float share)> report{}; ///< 0 to 1: how much is done
};

struct MadeFile {
    Bytes bytes;
    std::string remark{}; ///< a sentence: what of it is not as it was asked for; empty: all is
};

/// A file that is to be written.
struct FileOrder {
    std::filesystem::path file; ///< is written as a whole, or stays
    std::string_view failure;   ///< "The sheet can't be written: {}."
    std::size_t pictures = 0;   ///< that are drawn for it; 0: it is none of pictures
    /// On the thread that works. Errors become a sentence with `failure`, but Cancelled.
    std::function<Result<MadeFile>(const FileMaking&)> make;
    /// What the user has agreed to have replaced. What else is there by then stays, and this file gets a name
    /// that is free.
    std::optional<FileFingerprint> replaces{};
};

/// How far a file is.
struct FileProgress {
    std::filesystem::path file;
    std::size_t pictures = 0; ///< that are drawn for it; 0: it is none of pictures
    float share = 0;          ///< 0 to 1

    [[nodiscard]] std::size_t picturesDrawn() const;
};

/// A sentence for the user.
struct FileNews {
    std::string text;
    bool isGood = false; ///< it is written, with all that was asked for
};

/// Writes files whose making takes long, one after the other, beside the window. All functions are to be
/// called from one thread.
class FileWriting {
public:
    /// `wake` is called on the thread that works whenever there is news. `levels`: how textures are
    /// compressed at run time.
    explicit FileWriting(When when, std::function<void()> wake = {}, LevelWork levels = {});
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;
    ~FileWriting(); ///< what isn't written by then never is

    void write(FileOrder order);
    /// Of the one that is made; nothing: none is.
    [[nodiscard]] std::optional<FileProgress> progress() const;
    /// Gives up all that isn't written yet: its files stay what they were.
    void cancel();
    /// What there is to say, once: of the first that couldn't be written, or of the last that was.
    [[nodiscard]] std::optional<FileNews> takeNews();
    /// Sleeps until all is written.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::ui

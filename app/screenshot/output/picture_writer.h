#pragma once

#include "app/view/picture_texts.h"
#include "texplorer/base/worker.h"
#include "texplorer/codec/registry.h"

#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// A picture on its way into a file.
struct PictureJob {
    Image image;
    bool opaque = true; ///< written without its alpha
    std::filesystem::path path;
    const CodecRow* format = nullptr;
    std::optional<view::PictureFacts> facts{}; ///< written with it; none: pixels alone
    bool firstInFolder = false;                ///< the writer's own
};

/// Encodes pictures and writes their files, each as a whole, on threads of its own while the next ones are
/// drawn. What waits is bounded in number and bytes. After a file that can't be written no other is.
class PictureWriter {
public:
    explicit PictureWriter(unsigned threads);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    /// What waits is not written; what is being written is.
    ~PictureWriter();

    /// Waits where too much does already. Any thread may.
    void write(PictureJob job);

    /// Waits until all are written, or one can't be.
    void finish();

    [[nodiscard]] std::size_t written() const;
    /// Why a file couldn't be written; none: all could so far.
    [[nodiscard]] std::optional<Error> failure() const;

private:
    struct Answer {}; // there are none: what goes wrong is kept in failure_
    using Encoder = Worker<std::shared_ptr<PictureJob>, Answer>;
    class Accounted;

    std::unique_ptr<Encoder> makeEncoder(std::size_t index);
    void encode(PictureJob& job);
    void fail(const Error& error);

    mutable std::mutex mutex_; // guards what follows
    std::condition_variable freed_;
    std::size_t written_ = 0;
    std::size_t waitingBytes_ = 0;
    std::vector<std::size_t> waiting_; ///< pictures of each encoder, with the one that it does
    std::optional<Error> failure_;

    std::mutex asking_;                              ///< guards what follows
    std::set<std::filesystem::path> folders_;        ///< written to so far
    std::vector<std::unique_ptr<Encoder>> encoders_; ///< last: they end before the rest does
};

} // namespace texplorer::screenshot

#pragma once

#include "texplorer/texture/image_loader.h"

#include <map>

namespace texplorer::ui {

/// Small pictures of files, made on a separate thread. A list requests its visible ones in every frame;
/// pending ones that are no longer requested are cancelled.
class Thumbnails {
public:
    static constexpr std::size_t maxPictures = 256;

    explicit Thumbnails(std::function<void()> wake)
        : loader_(std::move(wake)) {}

    /// Call in every frame that shows the picture. `modified` distinguishes versions of a file.
    void ask(const std::filesystem::path& file, std::filesystem::file_time_type modified);
    /// nullptr: not ready, or the file has none.
    [[nodiscard]] std::shared_ptr<const Image> find(const std::filesystem::path& file) const;

    /// Call once before each frame. Returns true if a picture has arrived.
    bool receive();

    /// Blocks until all requested pictures can be received.
    void wait() const { loader_.wait(); }

private:
    struct Slot {
        std::filesystem::file_time_type modified{};
        ImageLoader::Ticket ticket = 0; ///< 0: nothing is pending
        std::shared_ptr<const Image> image;
        std::uint64_t frame = 0; ///< the last frame that requested it
    };

    void makeRoom();

    ImageLoader loader_;
    std::map<std::filesystem::path, Slot> slots_;
    std::uint64_t frame_ = 0;
};

} // namespace texplorer::ui

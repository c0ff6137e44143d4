#pragma once

#include "core/texture/image_loader.h"

#include <map>

namespace texplorer::ui {

/// Small pictures of files, made on a thread of their own. Who draws a list asks for those that are in sight
/// in every frame; what is no longer asked for is cancelled if it isn't there yet.
class Thumbnails {
public:
    static constexpr std::size_t mostPictures = 256;

    explicit Thumbnails(std::function<void()> wake)
        : loader_(std::move(wake)) {}

    /// nullptr: not there yet, or the file has none. `modified` tells a changed file from what it was.
    [[nodiscard]] std::shared_ptr<const Image> find(const std::filesystem::path& file,
                                                    std::filesystem::file_time_type modified);

    /// To be called once before each frame. True where a picture has come.
    bool receive();

    /// Sleeps until everything that was asked for can be received.
    void wait() const { loader_.wait(); }

private:
    struct Slot {
        std::filesystem::file_time_type modified{};
        ImageLoader::Ticket ticket = 0; ///< 0: nothing is waited for
        std::shared_ptr<const Image> image;
        std::uint64_t frame = 0; ///< in which it was asked for last
    };

    void makeRoom();

    ImageLoader loader_;
    std::map<std::filesystem::path, Slot> slots_;
    std::uint64_t frame_ = 0;
};

} // namespace texplorer::ui

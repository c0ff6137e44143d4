#pragma once

#include "app/stage/graphics.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace texplorer::stage {

/// How a host keeps pictures for the panels.
struct PictureUpload {
    /// Makes a picture of an Rgba8 image, bottom row first, edges clamped; None if that fails.
    std::function<view::PictureHandle(const Image& image, Graphics::Use use)> make;
    std::function<void(view::PictureHandle picture)> drop;
};

/// The pictures that panels show: uploaded at the first use, dropped when no longer shown. What `upload` uses
/// must outlive it.
class PictureCache {
public:
    explicit PictureCache(PictureUpload upload)
        : upload_(std::move(upload)) {}
    PictureCache(const PictureCache&) = delete;
    PictureCache& operator=(const PictureCache&) = delete;
    ~PictureCache();

    /// See Graphics::show.
    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image, Graphics::Use use);

    /// Drops what was not shown since the last call.
    void endFrame();

    /// Call when the host has lost all pictures: they are uploaded again.
    void forget() { slots_.clear(); }

private:
    struct Slot {
        view::PictureHandle picture = view::PictureHandle::None;
        std::uint64_t frame = 0; ///< the last frame that showed it
    };
    PictureUpload upload_;
    std::map<std::shared_ptr<const Image>, Slot> slots_; // owns the images: an address identifies one
    std::uint64_t frame_ = 0;
};

} // namespace texplorer::stage

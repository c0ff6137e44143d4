#include "app/stage/picture_cache.h"

#include "texplorer/image/convert.h"

#include <new>

namespace texplorer::stage {

PictureCache::~PictureCache() {
    for (const auto& [image, slot] : slots_)
        upload_.drop(slot.picture);
}

view::PictureHandle PictureCache::show(const std::shared_ptr<const Image>& image, Graphics::Use use) {
    if (!image || image->empty())
        return view::PictureHandle::None;
    try {
        const auto [slot, isNew] = slots_.try_emplace(image);
        slot->second.frame = frame_;
        if (isNew)
            slot->second.picture = image->format == PixelFormat::Rgba8 ? upload_.make(*image, use)
                                                                       : upload_.make(asRgba(*image), use);
        return slot->second.picture;
    } catch (const std::bad_alloc&) {
        return view::PictureHandle::None;
    }
}

void PictureCache::endFrame() {
    std::erase_if(slots_, [this](const auto& entry) {
        const bool isShown = entry.second.frame == frame_;
        if (!isShown)
            upload_.drop(entry.second.picture);
        return !isShown;
    });
    ++frame_;
}

} // namespace texplorer::stage

#include "app/render/picture_cache.h"

#include "app/render/state_guard.h"

#include <new>

namespace texplorer::render {

unsigned PictureCache::show(const std::shared_ptr<const Image>& image, Use use) {
    if (!image || image->empty())
        return 0;
    const auto [slot, isNew] = slots_.try_emplace(image);
    slot->second.frame = frame_;
    if (isNew) {
        GlErrors errors; // a picture that can't be shown is not worth a sentence
        try {
            const StateGuard guard;
            Texture plain;
            plain.minFilter = MinFilter::Linear;
            plain.magFilter = use == Use::Enlarged ? MagFilter::Nearest : MagFilter::Linear;
            plain.wrapS = plain.wrapT = Wrap::ClampToEdge;
            TextureLevels base;
            base.levels.push_back({0, *image});
            TextureObject object(Target::Texture2D, BaseFormat::Rgba, base, "picture", errors);
            object.apply(plain, 1, "picture", errors);
            if (errors.sentences().empty())
                slot->second.object = std::move(object);
        } catch (const std::bad_alloc&) {
            return 0;
        }
    }
    return slot->second.object.name();
}

void PictureCache::endFrame() {
    std::erase_if(slots_, [this](const auto& entry) { return entry.second.frame != frame_; });
    ++frame_;
}

} // namespace texplorer::render

#include "app/render/texture_preview.h"

#include "app/render/state_guard.h"
#include "core/scene/target_image.h"

#include <new>

namespace texplorer::render {

unsigned TexturePreview::show(const Texture& texture, const ImageSource& images) {
    std::shared_ptr<const Image> image = images.find(texture);
    if (!image || image->empty())
        return 0;
    if (image != image_ || texture.internalFormat != format_) {
        image_ = std::move(image);
        format_ = texture.internalFormat;
        object_ = TextureObject();
        GlErrors errors; // the renderer reports the same ones about the texture itself
        try {
            const StateGuard guard;
            Texture plain;
            plain.magFilter = MagFilter::Nearest;
            plain.minFilter = MinFilter::Nearest;
            plain.wrapS = plain.wrapT = Wrap::ClampToEdge;
            MipChain base;
            base.push_back(imageForTarget(*image_, Target::Texture2D));
            TextureObject object(Target::Texture2D, format_, base, "preview", errors);
            object.apply(plain, 1, "preview", errors);
            if (errors.sentences().empty())
                object_ = std::move(object);
        } catch (const std::bad_alloc&) {
            return 0;
        }
    }
    return object_.name();
}

} // namespace texplorer::render

#include "app/render/texture_preview.h"

#include "app/render/state_guard.h"

#include <new>

namespace texplorer::render {

unsigned TexturePreview::show(const Texture& texture, const ImageSource& images, LevelsSource* levels) {
    const std::optional<LevelsRequest> request = picture_.request(texture, images);
    if (!request)
        return 0;
    if (!live_.shows(*request) || live_.isUploading()) {
        try {
            const StateGuard guard;
            live_.follow(*request, nullptr, levels, "preview");
            Texture plain;
            plain.magFilter = MagFilter::Nearest;
            plain.minFilter = MinFilter::Nearest;
            plain.wrapS = plain.wrapT = Wrap::ClampToEdge;
            GlErrors errors;
            if (live_.object().name() != 0)
                live_.object().apply(plain, 1, "preview", errors);
        } catch (const std::bad_alloc&) {
            return 0;
        }
    }
    return live_.object().name(); // the renderer reports the same errors for the texture itself
}

} // namespace texplorer::render

#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/texture_object.h"
#include "core/scene/image_source.h"
#include "core/scene/scene.h"

#include <map>
#include <memory>

namespace texplorer::render {

/// The texture objects of a scene: one for each texture and target that it is used with. Images are uploaded
/// when the pixels, the internal format or the mip policy changed, parameters when they changed.
class TextureCache {
public:
    explicit TextureCache(const Capabilities& capabilities)
        : capabilities_(capabilities) {}

    /// The name of the texture object, up to date; 0 where it can't be drawn: then a sentence in `errors`
    /// says why. `index` must be one of the scene's textures.
    [[nodiscard]] GLuint prepare(const Scene& scene, std::size_t index, Target target,
                                 const ImageSource& images, GlErrors& errors);

    /// Forgets the texture objects of textures that a scene with `count` textures does not have.
    void keepFirst(std::size_t count);

private:
    struct Slot {
        std::shared_ptr<const Image> image; // held, so that no other image can come to have this address
        BaseFormat format{};
        MipPolicy mipmaps{};
        TextureObject object;
        GlErrors uploadErrors; // repeated with every frame, for as long as the texture is like this
        bool usable = false;
    };

    void upload(Slot& slot, Target target, std::string_view where) const;

    Capabilities capabilities_;
    std::map<std::pair<std::size_t, Target>, Slot> slots_;
};

} // namespace texplorer::render

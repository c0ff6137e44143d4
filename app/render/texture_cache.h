#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/texture_object.h"
#include "core/scene/image_source.h"
#include "core/scene/scene.h"

#include <map>
#include <memory>

namespace texplorer::render {

/// What is bound to a unit, and what is left to do for it.
struct BoundTexture {
    GLuint name = 0; ///< 0: drawn without it
    LateFlip lateFlip = LateFlip::None;
};

/// The texture objects of a scene: one for each texture and target that it is used with. Images are uploaded
/// when the pixels or what is made of them changed (imageSettings), parameters when they changed.
class TextureCache {
public:
    explicit TextureCache(const Capabilities& capabilities)
        : capabilities_(capabilities) {}

    /// The texture object, up to date; its name is 0 where it can't be drawn: then a sentence in `errors`
    /// says why. What was done otherwise than asked for is said there, too. `index` must be one of the
    /// scene's textures.
    [[nodiscard]] BoundTexture prepare(const Scene& scene, std::size_t index, Target target,
                                       const ImageSource& images, GlErrors& errors);

    /// What `prepare` made last, or nullptr.
    [[nodiscard]] const TextureObject* find(std::size_t index, Target target) const;

    /// Forgets the texture objects of textures that a scene with `count` textures does not have.
    void keepFirst(std::size_t count);

private:
    struct Slot {
        std::shared_ptr<const TextureImage> image; // held, so that no other can come to have this address
        Texture settings;                          // those of imageSettings
        TextureObject object;
        int lastLevel = 1000;
        LateFlip lateFlip = LateFlip::None;
        GlErrors uploadErrors; // repeated with every frame, for as long as the texture is like this
        bool usable = false;
    };

    void upload(Slot& slot, Target target, std::string_view where) const;

    void decompressForDriver(TextureLevels& levels, std::string_view where, GlErrors& errors) const;

    Capabilities capabilities_;
    std::map<std::pair<std::size_t, Target>, Slot> slots_;
};

} // namespace texplorer::render

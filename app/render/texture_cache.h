#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/live_texture.h"
#include "app/view/driver_facts.h"
#include "core/diagnosis/visited_texels.h"
#include "core/reference/light_depth.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <cstdint>
#include <map>

namespace texplorer::render {

/// What is bound to a unit, and what is left to do for it.
struct BoundTexture {
    GLuint name = 0; ///< 0: drawn without it; incomplete textures are, too (section 3.8.10)
    LateFlip lateFlip = LateFlip::None;
    BaseFormat format = BaseFormat::Rgba; ///< the base internal format, which the environment asks for
    bool hasNegative = false;             ///< its format is signed
    float lodBias = 0;                    ///< of the texture object
    bool hasDepths = false;               ///< and no colours
    bool compares = false;                ///< r with its depths
};

/// The LOD bias that a unit is given beside that of its texture object. Below equation 3.18 OpenGL limits
/// their sum, which Mesa 22.3 doesn't: where the sum is beyond the limit, the unit adds what is left up to
/// it.
[[nodiscard]] float unitBias(const Unit& unit, const BoundTexture& texture);

/// The texture objects of a scene: one for each texture and target that it is used with. Images are uploaded
/// when the pixels or what is made of them changed (imageSettings), parameters when they changed.
class TextureCache {
public:
    explicit TextureCache(const view::Capabilities& capabilities)
        : capabilities_(capabilities)
        , facts_(driverFacts(capabilities)) {}

    /// The texture object, up to date; its name is 0 where it can't be drawn: then a sentence in `errors`
    /// says why. What was done otherwise than asked for is said there, too. With `levels` it may be what it
    /// was before, or 0, until its levels are made and uploaded.
    [[nodiscard]] BoundTexture prepare(const TextureUse& use, Target target, const ImageSource& images,
                                       LevelsSource* levels, GlErrors& errors);

    /// The images with what the light sees: the same ones for all that have this cache.
    [[nodiscard]] ImageSource withLightDepths(const ImageSource& images, const Scene& scene, double time) {
        return lightDepths_.addedTo(images, scene, time);
    }

    /// What `prepare` made last, or nullptr.
    [[nodiscard]] const TextureObject* find(std::size_t index, Target target) const;

    /// Forgets the texture objects that no unit of the scene names, whether it is on or off.
    void keepOnly(const Scene& scene);

    /// Whether an upload has to go on with the next frame.
    [[nodiscard]] bool isUploading() const;

    /// Grows whenever a texture shows other texels than before.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

private:
    view::Capabilities capabilities_;
    DriverFacts facts_;
    reference::LightDepths lightDepths_;
    std::map<std::pair<std::size_t, Target>, LiveTexture> slots_;
    std::uint64_t revision_ = 0;
};

} // namespace texplorer::render

#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/live_texture.h"
#include "app/view/driver_facts.h"
#include "texplorer/diagnosis/visited_texels.h"
#include "texplorer/reference/drawn_pictures.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <cstdint>
#include <map>

namespace texplorer::render {

/// A texture bound to a unit, and what is still to do for it.
struct BoundTexture {
    GLuint name = 0; ///< 0: drawn without a texture, as with an incomplete one (section 3.8.10)
    LateFlip lateFlip = LateFlip::None;
    BaseFormat format = BaseFormat::Rgba; ///< the base internal format, used by the environment
    bool isUnclamped = false;             ///< its texels may lie outside 0 … 1
    float lodBias = 0;                    ///< from the texture object
    bool hasDepths = false;               ///< depths instead of colours
    bool compares = false;                ///< compares r with its depths
};

/// The LOD bias of a unit, which is added to that of the texture object. OpenGL limits their sum (below
/// equation 3.18), Mesa 22.3 does not: if the sum is beyond the limit, the unit gets only the rest up to it.
[[nodiscard]] float unitBias(const Unit& unit, const BoundTexture& texture);

/// The texture objects of a scene: one for each texture and each target that it is used with. Images are
/// uploaded when the pixels or their settings (imageSettings) changed, parameters when they changed.
class TextureCache {
public:
    explicit TextureCache(const view::Capabilities& capabilities)
        : capabilities_(capabilities)
        , facts_(driverFacts(capabilities)) {}

    /// Returns the updated texture object; its name is 0 if it cannot be drawn, and `errors` says why. Notes
    /// about differences from the request go there as well. With `levels` it may have its previous content,
    /// or the name 0, until its levels are made and uploaded.
    [[nodiscard]] BoundTexture prepare(const TextureUse& use, Target target, const ImageSource& images,
                                       LevelsSource* levels, GlErrors& errors);

    /// The images including the light's view and the pictures of passes, which `draw` draws: the same ones
    /// for all users of this cache. The first scene is `scene` at that time.
    [[nodiscard]] Result<ImageSource> withDrawn(const ImageSource& images, const Scene& standing,
                                                const Scene& scene, double time,
                                                const reference::DrawPicture& draw) {
        return pictures_.addedTo(lightDepths_.addedTo(images, standing, time), scene, time, draw, revision_);
    }

    /// The result of the last `prepare`, or nullptr.
    [[nodiscard]] const TextureObject* find(std::size_t index, Target target) const;

    /// What the driver stores, by texture of the scene and target.
    [[nodiscard]] std::map<std::pair<std::size_t, Target>, std::shared_ptr<const view::StoredTexture>>
    stored() const;

    /// Deletes the texture objects that no unit of the scene names, whether the unit is on or off.
    void keepOnly(const Scene& scene);

    /// Whether an upload continues in the next frame.
    [[nodiscard]] bool isUploading() const;

    /// Increases whenever a texture shows different texels.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

private:
    view::Capabilities capabilities_;
    DriverFacts facts_;
    reference::LightDepths lightDepths_;
    reference::DrawnPictures pictures_;
    std::map<std::pair<std::size_t, Target>, LiveTexture> slots_;
    std::uint64_t revision_ = 0;
};

} // namespace texplorer::render

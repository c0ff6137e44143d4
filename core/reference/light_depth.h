#pragma once

// Depth textures of a scene from the light's view.

#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace texplorer::reference {

/// Draws the depths from lightView() (texplorer/scene/animation.h): Depth32, `size` x `size`, row 0 at the
/// bottom, 24 bits each. All models that a pass draws are drawn, also those attached to the eye, with a depth
/// test of GL_LESS over the largest depth. Incomplete after a stop request.
[[nodiscard]] Image drawLightDepths(const Scene& scene, double time, int size,
                                    const std::stop_token& stop = {});

/// Whether an enabled unit uses a texture of the light's view.
[[nodiscard]] bool showsLightDepths(const Scene& scene);

/// The depth pictures of a scene, drawn if a texture uses them and cached until what they depend on changes.
class LightDepths {
public:
    /// Returns `images` with the light's view in every size that a unit uses and that is missing. After a
    /// stop request, some may be missing; incomplete ones are not cached.
    [[nodiscard]] ImageSource addedTo(const ImageSource& images, const Scene& scene, double time,
                                      const std::stop_token& stop = {});

private:
    /// Everything that the pictures depend on.
    struct Seen {
        View view;
        Light light;
        std::vector<Model> models; ///< those that are drawn
        double time;
        bool turns; ///< they depend on the time

        Seen(const Scene& scene, double time);
        [[nodiscard]] bool holds(const Scene& scene, double time) const;
    };

    std::optional<Seen> seen_;
    std::map<int, std::shared_ptr<const TextureImage>> pictures_; ///< by size
};

} // namespace texplorer::reference

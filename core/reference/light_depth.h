#pragma once

// What the light sees of a scene, as pictures of depths: for textures whose source it is.

#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace texplorer::reference {

/// The depths that the light sees through lightView() (core/scene/animation.h): Depth32, `size` x `size`, row
/// 0 at the bottom, 24 bits each. Drawn are all models that a pass draws, those attached to the eye too, with
/// a depth test of GL_LESS over the farthest depth. Unfinished after a stop request.
[[nodiscard]] Image drawLightDepths(const Scene& scene, double time, int size,
                                    const std::stop_token& stop = {});

/// Whether a unit that is on shows what the light sees.
[[nodiscard]] bool showsLightDepths(const Scene& scene);

/// Those of a scene, made where something shows them and kept as long as nothing changes that they depend on.
class LightDepths {
public:
    /// `images`, with what the light sees in every size that a unit shows and that isn't there yet. After a
    /// stop request some may be missing; what is unfinished is not kept.
    [[nodiscard]] ImageSource addedTo(const ImageSource& images, const Scene& scene, double time,
                                      const std::stop_token& stop = {});

private:
    /// All that decides.
    struct Seen {
        View view;
        Light light;
        std::vector<Model> models; ///< that are drawn
        double time;
        bool turns; ///< whether the time counts

        Seen(const Scene& scene, double time);
        [[nodiscard]] bool holds(const Scene& scene, double time) const;
    };

    std::optional<Seen> seen_;
    std::map<int, std::shared_ptr<const TextureImage>> pictures_; ///< by their size
};

} // namespace texplorer::reference

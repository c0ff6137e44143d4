#pragma once

#include "core/reference/sampling/sampled_texture.h"
#include "core/texture/image_source.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A texture that is ready to be sampled, and what is left to do for it.
struct StoredTexture {
    SampledTexture sampled;
    LateFlip lateFlip = LateFlip::None;
    bool complete = false; ///< where it isn't, the unit is drawn as if it were off
};

/// The sampled textures of a scene, one for each texture and target. Levels are made again when the pixels or
/// what is made of them changed (imageSettings).
class TextureStore {
public:
    /// Brings one of the scene's textures up to date; nullptr where it can't be drawn, or the work was
    /// stopped. What was returned before stays valid until `keepOnly`. Sentences about what stands in the
    /// way, or was done otherwise than asked for, are added to `problems`.
    [[nodiscard]] const StoredTexture* prepare(const Scene& scene, std::size_t index, Target target,
                                               const ImageSource& images, const LevelWork& work,
                                               std::vector<std::string>& problems);

    /// Forgets what no unit of the scene samples: at 16 bytes a texel, it is not kept for later.
    void keepOnly(const Scene& scene);

private:
    struct Slot {
        TexturePictures pictures; ///< held, so that no others can come to have these addresses
        Texture settings;         // those of imageSettings
        StoredTexture texture;
        int lastLevel = 1000;
        std::vector<std::string> notes; // repeated with every picture
        bool usable = false;
    };
    static Slot filled(TexturePictures pictures, Texture settings, Target target, const LevelWork& work,
                       const std::string& where);

    std::map<std::pair<std::size_t, Target>, Slot> slots_;
};

} // namespace texplorer::reference

#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/texture/image_source.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A texture prepared for sampling.
struct StoredTexture {
    SampledTexture sampled;
    LateFlip lateFlip = LateFlip::None;
    bool complete = false;     ///< if false, the unit is drawn as if it were disabled
    std::uint64_t version = 0; ///< of its levels: different levels, another number
    /// Of a custom upload, whose levels have the memory that was read; else nullptr.
    std::shared_ptr<const TextureLevels> uploaded{};
};

/// Whether an enabled unit of a pass that is drawn samples this texture.
[[nodiscard]] bool isSampled(const Scene& scene, std::size_t texture, Target target);

/// The sampled textures of a scene, one for each texture and target. Levels are made again if the pixels or
/// the settings that change them (imageSettings) have changed.
class TextureStore {
public:
    /// Updates one of the scene's textures; returns nullptr if it cannot be drawn or the work was stopped.
    /// Earlier results stay valid until `keepOnly`. Sentences about errors and changed settings are added to
    /// `problems`.
    [[nodiscard]] const StoredTexture* prepare(const Scene& scene, std::size_t index, Target target,
                                               const ImageSource& images, const LevelWork& work,
                                               std::vector<Sentence>& problems);

    /// Removes textures that no unit of the scene samples: at 16 bytes per texel, they are not cached.
    void keepOnly(const Scene& scene);

private:
    struct Slot {
        TexturePictures pictures; ///< held, so that their addresses are not reused
        Texture settings;         // from imageSettings
        StoredTexture texture;
        int lastLevel = 1000;
        std::vector<Sentence> notes; // repeated with every picture
        bool usable = false;
    };
    static Slot filled(TexturePictures pictures, Texture settings, Target target, const LevelWork& work,
                       const std::string& where);

    std::map<std::pair<std::size_t, Target>, Slot> slots_;
    std::uint64_t versions_ = 0;
};

} // namespace texplorer::reference

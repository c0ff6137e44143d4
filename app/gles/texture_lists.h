#pragma once

#include "app/gles/object.h"
#include "texplorer/reference/sampling/texture_store.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace texplorer::gles {

/// A texture of the scene on the device.
struct ListedTexture {
    std::uint64_t version = 0;                     ///< of reference::StoredTexture
    Object texels;                                 ///< nullptr: the device can't hold them
    std::vector<std::optional<glm::ivec4>> levels; ///< of TexelList
    bool isUnclamped = false;                      ///< its texels may lie outside 0 … 1
    Sentence problem;
};

/// What a unit samples.
struct BoundTexture {
    const reference::StoredTexture* stored = nullptr; ///< nullptr: nothing
    const ListedTexture* listed = nullptr;
};

/// The textures of a scene as lists of texels on a device. Made again when their texels change.
class TextureLists {
public:
    TextureLists(Device& device, LevelWork work)
        : device_(device)
        , work_(std::move(work)) {}

    /// Returns one of the scene's textures, or nothing if it cannot be drawn or is incomplete; valid until
    /// `keepOnly`. Sentences about it are added to `problems`.
    [[nodiscard]] BoundTexture prepare(const Scene& scene, std::size_t index, Target target,
                                       const ImageSource& images, std::vector<Sentence>& problems);

    [[nodiscard]] const LevelWork& work() const { return work_; }

    /// Removes textures that no unit of the scene samples.
    void keepOnly(const Scene& scene);

private:
    const ListedTexture& listedOf(const reference::StoredTexture& stored, std::size_t texture);

    Device& device_;
    LevelWork work_;
    reference::TextureStore store_;
    std::map<std::pair<std::size_t, Target>, ListedTexture> lists_;
};

} // namespace texplorer::gles

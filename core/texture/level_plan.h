#pragma once

// The levels that a texture will have, without making them: enough to check completeness and size limits.

#include "texplorer/scene/upload.h"
#include "texplorer/texture/texture_pictures.h"

#include <optional>
#include <vector>

namespace texplorer {

struct PlannedLevel {
    int number = 0; ///< GL's: 0 is the base
    int width = 0;  ///< extents without border
    int height = 1;
    int depth = 1;

    bool operator==(const PlannedLevel&) const = default;
};

/// The base level of a custom upload in the program's memory.
struct PlannedUpload {
    MemoryLayout memory{};
    PixelExtent extent{}; ///< with the border
    Sentence refusal{};   ///< why OpenGL refuses the call; empty: it doesn't
};

/// A subimage that is not made.
struct RefusedSubimage {
    std::size_t index; ///< into Texture::subimages
    Sentence why;
    bool isCalled; ///< OpenGL refuses the call; otherwise there is none
};

struct LevelPlan {
    std::vector<PlannedLevel> levels;  ///< ascending; the same for every face
    int lastLevel = 1000;              ///< as in TextureLevels
    int border = 0;                    ///< as in TextureLevels
    std::optional<BlockFormat> blocks; ///< kept from the file, or the format that the driver compresses to
    std::optional<PlannedUpload> upload{}; ///< of pixels; if it is refused, there are no levels
    std::vector<RefusedSubimage> refusedSubimages{};
    /// Why OpenGL refuses the internal format or the border; empty: it doesn't. Otherwise there are no
    /// levels.
    Sentence refusal{};
    Sentence
        fallback{}; ///< what is drawn of an image that is too large (Oversize::Smaller); empty: all of it
};

/// The extents of a level above a base (OpenGL 2.1, section 3.8.8).
[[nodiscard]] PlannedLevel levelAbove(const PlannedLevel& base, int number);

/// Returns the numbers and extents of prepareLevels' result, immediately for any size; outlines are enough.
/// Empty for an empty image.
[[nodiscard]] LevelPlan planLevels(const Texture& texture, const TexturePictures& pictures, Target target);

} // namespace texplorer

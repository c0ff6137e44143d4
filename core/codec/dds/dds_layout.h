#pragma once

// The positions of the surfaces of a DDS file, computed from its header alone.

#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/codec/dds/dds_format.h"

namespace texplorer::dds {

/// One level of one face.
struct Level {
    int width;
    int height;
    int depth;
    std::uint64_t offset; ///< in the file
    std::uint64_t size;
};

/// The limit of Direct3D 11; where all elements are read, longer arrays are refused.
inline constexpr std::uint32_t maxElements = 2048;

/// The faces follow each other without gaps, each with all its levels, largest first; so do the elements of
/// an array.
struct Layout {
    Format format;
    int width = 0;
    int height = 0;
    int depth = 1;
    int faces = 1;
    int levels = 1;             ///< as the header says, if that is plausible
    std::uint32_t elements = 1; ///< the number of such textures in an array
    std::uint64_t begin = legacyEnd;

    /// level is below 31; in an array, faces are counted across elements
    [[nodiscard]] Level at(int face, int level) const;
    /// The bytes of `count` levels of one face.
    [[nodiscard]] std::uint64_t chainBytes(int count) const;
    /// The end of the last face's last level; in an array, of the first element.
    [[nodiscard]] std::uint64_t end() const {
        return begin + static_cast<std::uint64_t>(faces) * chainBytes(levels);
    }
    /// The end of the last element; the largest number if that overflows.
    [[nodiscard]] std::uint64_t arrayEnd() const;
};

/// "+x" to "-z"
[[nodiscard]] std::string_view faceName(int face);

/// Refuses what is not supported (partial cube maps, unknown formats) and what exceeds the limits. Errors
/// that Direct3D's loaders tolerate are added to `findings`. The file's size is used only to choose between
/// two readings of a wrong mip count, and to check that the headers are complete.
[[nodiscard]] Result<Layout> planLayout(ByteView file, const DecodeLimits& limits, Findings& findings);

/// Returns how many levels of every face are complete in a file of this size, at most layout.levels. Errors:
/// level 0 of a face, or any part of an array, is incomplete.
[[nodiscard]] Result<int> wholeLevels(const Layout& layout, std::size_t fileSize, Findings& findings);

} // namespace texplorer::dds

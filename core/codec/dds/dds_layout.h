#pragma once

// Where the surfaces of a DDS file are, worked out from its header alone.

#include "core/codec/common/decode_limits.h"
#include "core/codec/dds/dds_format.h"

namespace texplorer::dds {

/// One level of one face.
struct Level {
    int width;
    int height;
    int depth;
    std::uint64_t offset; ///< in the file
    std::uint64_t size;
};

/// Direct3D 11's; an array of more is refused where every element is read.
inline constexpr std::uint32_t maxElements = 2048;

/// The faces follow each other, each with all its levels, largest first, without gaps; so do the elements of
/// an array.
struct Layout {
    Format format;
    int width = 0;
    int height = 0;
    int depth = 1;
    int faces = 1;
    int levels = 1;             ///< that the header says, where it can be believed
    std::uint32_t elements = 1; ///< of an array of such textures
    std::uint64_t begin = legacyEnd;

    /// level is below 31; the faces of an array are counted through its elements
    [[nodiscard]] Level at(int face, int level) const;
    /// Of `count` levels of one face.
    [[nodiscard]] std::uint64_t chainBytes(int count) const;
    /// Where the last face's last level ends, in an array that of the first element.
    [[nodiscard]] std::uint64_t end() const {
        return begin + static_cast<std::uint64_t>(faces) * chainBytes(levels);
    }
    /// Where the last element ends; as much as there is where that is beyond all numbers.
    [[nodiscard]] std::uint64_t arrayEnd() const;
};

/// "+x" to "-z"
[[nodiscard]] std::string_view faceName(int face);

/// Refuses what is not read (partial cube maps, unknown formats) and what exceeds the limits;
/// anything that Direct3D's loaders overlook is added to `findings`. The file's size is looked at only to
/// choose between two readings of a wrong mip count, and to check that the headers are there.
[[nodiscard]] Result<Layout> planLayout(ByteView file, const DecodeLimits& limits, Findings& findings);

/// How many levels of every face are whole in a file of this size, at most layout.levels. Refused where level
/// 0 of a face isn't, or an array lacks anything.
[[nodiscard]] Result<int> wholeLevels(const Layout& layout, std::size_t fileSize, Findings& findings);

} // namespace texplorer::dds

#pragma once

// The files that the sweep's scenes refer to. They are generated, and written next to a report's scenes.

#include "texplorer/base/bytes.h"
#include "texplorer/texture/image_source.h"

#include <array>
#include <string_view>

namespace texplorer::conform {

struct MadeFile {
    std::string_view name;
    int levels; ///< 1 to 7, as many as a picture of 64 x 64 can have
};

/// DDS files, with all levels or only the first ones.
inline constexpr std::array madeFiles{
    MadeFile{"level-1-of-7.dds", 1},
    MadeFile{"levels-3-of-7.dds", 3},
    MadeFile{"levels-7-of-7.dds", 7},
};

[[nodiscard]] Bytes bytesOf(const MadeFile& file);

/// All of them, loaded.
[[nodiscard]] const ImageSource& madeImages();

} // namespace texplorer::conform

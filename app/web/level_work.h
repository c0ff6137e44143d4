#pragma once

#include "texplorer/texture/texture_levels.h"

namespace texplorer::web {

/// How textures are compressed: the blocks are kept in memory, as all files of the program are.
[[nodiscard]] inline LevelWork levelWork() {
    return {.cache = BlockCache("/tmp/blocks", std::uintmax_t{64} << 20)};
}

} // namespace texplorer::web

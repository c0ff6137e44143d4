#pragma once

#include <cstdint>

namespace texplorer::view {

/// A picture that the host keeps for the panels: a number that means something to the host alone.
enum class PictureHandle : std::uintptr_t {
    None = 0 ///< there is none
};

} // namespace texplorer::view

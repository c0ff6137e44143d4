#pragma once

#include <cstdint>

namespace texplorer::view {

/// The sides of a comparison in time: the current document, or the kept state A.
enum class Side : std::uint8_t { Now, Kept };

} // namespace texplorer::view

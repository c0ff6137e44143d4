#pragma once

#include <cstdint>

namespace texplorer::view {

/// Of a comparison in time: what the document shows now, or what was kept of it as A.
enum class Side : std::uint8_t { Now, Kept };

} // namespace texplorer::view

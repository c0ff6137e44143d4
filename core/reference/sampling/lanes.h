#pragma once

// Four numbers at a time, which every processor supports: SSE2 on x86-64.

#include <glm/vec4.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#define TEXPLORER_LANES 4
namespace texplorer::reference {

#include "texplorer/reference/sampling/lanes.inl"

[[nodiscard]] inline float logarithm2(float value) {
    return logarithms2(floats(value))[0];
}

} // namespace texplorer::reference
#undef TEXPLORER_LANES

#pragma once

// What the kernel's text needs. All of it is read before the text, because nothing from outside of it may be
// compiled for a processor that is not there.

#include "core/reference/raster/canvas.h"
#include "core/reference/raster/kernel.h"
#include "core/reference/shading/combine.h"
#include "core/reference/shading/environment.h"
#include "core/reference/shading/fog.h"
#include "core/reference/shading/fragment.h"
#include "core/reference/shading/pass_state.h"
#include "core/reference/shading/stored_color.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

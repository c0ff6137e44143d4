#pragma once

// The headers of the kernel's source. They are included before it, because code from outside must not be
// compiled for a processor that may be missing.

#include "texplorer/reference/raster/canvas.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/shading/combine.h"
#include "texplorer/reference/shading/environment.h"
#include "texplorer/reference/shading/fog.h"
#include "texplorer/reference/shading/fragment.h"
#include "texplorer/reference/shading/pass_state.h"
#include "texplorer/reference/shading/stored_color.h"

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

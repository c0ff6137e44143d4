#pragma once

// What the kernel's text needs. All of it is read before the text, because nothing from outside of it may be
// compiled for a processor that is not there.

#include "core/reference/canvas.h"
#include "core/reference/combine.h"
#include "core/reference/environment.h"
#include "core/reference/fragment.h"
#include "core/reference/kernel/kernel.h"
#include "core/reference/pass_state.h"
#include "core/reference/stored_color.h"

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

#include "texplorer/reference/raster/kernel_headers.h"

#if defined(__x86_64__)

#define TEXPLORER_LANES 8

// Only what stands between these lines is compiled for AVX2.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

namespace texplorer::reference {
namespace {
namespace eight {

// Each builds on the one before it.
// clang-format off
#include "texplorer/reference/sampling/lanes.inl"
#include "texplorer/reference/sampling/sample.inl"
#include "texplorer/reference/raster/shade.inl"
// clang-format on

} // namespace eight
} // namespace
} // namespace texplorer::reference

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

namespace texplorer::reference {

const Kernel* eightLanes() {
    return __builtin_cpu_supports("avx2") ? &eight::kernel : nullptr;
}

} // namespace texplorer::reference

#else

namespace texplorer::reference {

const Kernel* eightLanes() {
    return nullptr;
}

} // namespace texplorer::reference

#endif

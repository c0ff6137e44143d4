#include "core/reference/raster/kernel_headers.h"

#define TEXPLORER_LANES 4

namespace texplorer::reference {
namespace {
namespace four {

// Each builds on the one before it.
// clang-format off
#include "core/reference/sampling/lanes.inl"
#include "core/reference/sampling/sample.inl"
#include "core/reference/raster/shade.inl"
// clang-format on

} // namespace four
} // namespace

const Kernel* fourLanes() {
    return &four::kernel;
}

} // namespace texplorer::reference

#include "texplorer/reference/raster/kernel_headers.h"

#define TEXPLORER_LANES 4

namespace texplorer::reference {
namespace {
namespace four {

// Each builds on the one before it.
// clang-format off
#include "texplorer/reference/sampling/lanes.inl"
#include "texplorer/reference/sampling/sample.inl"
#include "texplorer/reference/raster/shade.inl"
// clang-format on

} // namespace four
} // namespace

const Kernel* fourLanes() {
    return &four::kernel;
}

} // namespace texplorer::reference

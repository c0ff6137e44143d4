#include "core/reference/raster/kernel_headers.h"

#define TEXPLORER_LANES 4

namespace texplorer::reference {
namespace {
namespace four {

#include "core/reference/raster/shade.inl"
#include "core/reference/sampling/lanes.inl"
#include "core/reference/sampling/sample.inl"

} // namespace four
} // namespace

const Kernel* fourLanes() {
    return &four::kernel;
}

} // namespace texplorer::reference

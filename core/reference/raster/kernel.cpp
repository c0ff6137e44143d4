#include "texplorer/reference/raster/kernel.h"

#include <array>

namespace texplorer::reference {

std::span<const Kernel* const> kernels() {
    static const std::array all{eightLanes(), fourLanes()};
    return std::span(all).subspan(all[0] ? 0 : 1);
}

} // namespace texplorer::reference

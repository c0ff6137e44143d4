#include "core/compare/pixel_metric.h"

#include "core/compare/absolute.h"
#include "core/compare/flip.h"
#include "core/compare/ssim.h"

namespace texplorer {

std::unique_ptr<PixelMetric> makePixelMetric(const Criterion& criterion, bool opaque, const Tile& maxTile) {
    switch (criterion.metric) {
    case Metric::Ssim:
        return makeSsim(opaque, maxTile);
    case Metric::Flip:
        return makeFlip(criterion.pixelsPerDegree, opaque, maxTile);
    case Metric::Absolute:
        break;
    }
    return makeAbsolute(criterion.compared);
}

} // namespace texplorer

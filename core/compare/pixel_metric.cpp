#include "texplorer/compare/pixel_metric.h"

#include "texplorer/compare/absolute.h"
#include "texplorer/compare/flip.h"
#include "texplorer/compare/ssim.h"

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

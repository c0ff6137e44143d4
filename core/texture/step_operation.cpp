#include "texplorer/texture/step_operation.h"

#include <algorithm>

namespace texplorer {

PlannedLevel resizedBy(const ImageStep& step, const PlannedLevel& level) {
    if (step.op != ImageOp::Resize)
        return level;
    const auto extent = [&](int texels, int wanted) {
        return std::max(1, wanted > 0 ? wanted >> level.number
                                      : static_cast<int>(static_cast<double>(texels) * double{step.share}));
    };
    return {level.number, extent(level.width, step.width), extent(level.height, step.height),
            extent(level.depth, 0)};
}

Operation operationOf(const ImageStep& step, const PlannedLevel& level, bool topFirst, const Image* other) {
    const PlannedLevel made = resizedBy(step, level);
    return {step.op,
            step.factor,
            step.bias,
            step.amount,
            {step.red, step.green, step.blue, step.alpha},
            {made.width, made.height, made.depth},
            topFirst,
            other};
}

} // namespace texplorer

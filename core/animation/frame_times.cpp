#include "texplorer/animation/frame_times.h"

#include <algorithm>
#include <cmath>

namespace texplorer::animation {

std::vector<int> durationsOf(std::size_t frames, double perSecond, double seconds, int units) {
    std::vector<int> durations;
    durations.reserve(frames);
    const auto unitAt = [&](std::size_t frame) {
        const double time = frame == frames ? seconds : static_cast<double>(frame) / perSecond;
        return std::llround(time * units);
    };
    for (std::size_t i = 0; i < frames; ++i)
        durations.push_back(static_cast<int>(std::max(1LL, unitAt(i + 1) - unitAt(i))));
    return durations;
}

} // namespace texplorer::animation

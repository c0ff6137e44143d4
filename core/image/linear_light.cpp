#include "texplorer/image/linear_light.h"

#include <cmath>

namespace texplorer {

namespace {

double lightOf(double stored) {
    return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

double storedOf(double light) {
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

LinearLight makeTable() {
    LinearLight made;
    for (std::size_t i = 0; i < made.light.size(); ++i) {
        const double light = lightOf(static_cast<double>(i) / 255);
        made.light[i] = static_cast<std::uint16_t>(std::lround(light * 65535));
        made.exactLight[i] = static_cast<float>(light);
    }
    made.stored.resize(65536);
    for (std::size_t i = 0; i < made.stored.size(); ++i)
        made.stored[i] =
            static_cast<std::uint8_t>(std::lround(storedOf(static_cast<double>(i) / 65535) * 255));
    return made;
}

} // namespace

const LinearLight& LinearLight::table() {
    static const LinearLight made = makeTable();
    return made;
}

} // namespace texplorer

#include "texplorer/compare/absolute.h"

#include "texplorer/compare/pixel_difference.h"

namespace texplorer {

namespace {

class AbsoluteMetric : public PixelMetric {
public:
    explicit AbsoluteMetric(Compared compared)
        : components_(componentsOf(compared)) {}

    [[nodiscard]] int reach() const override { return 0; }

    void measure(const TilePixels& pixels, std::span<float> values) override {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(
                differenceOf(pixels.expected[i].data(), pixels.actual[i].data(), components_).worst);
    }

private:
    std::size_t components_;
};

} // namespace

std::unique_ptr<PixelMetric> makeAbsolute(Compared compared) {
    return std::make_unique<AbsoluteMetric>(compared);
}

} // namespace texplorer

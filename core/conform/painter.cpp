#include "core/conform/painter.h"

#include "core/conform/feature.h"
#include "core/conform/lambda_range.h"
#include "core/reference/draw.h"

namespace texplorer::conform {

namespace {

class ReferencePainter : public Explainer {
public:
    ReferencePainter() {
        options_.threads = 1;
        options_.anisotropy = reference::AnisotropyMethod::Ellipse;
    }
    Result<Painting> paint(const Scene& scene) override {
        Result<reference::Drawn> drawn = renderer_.draw(scene, images_, 0, extent, extent, options_);
        if (!drawn)
            return fail(drawn.error());
        return Painting{std::move(drawn->image), std::move(drawn->problems)};
    }
    Result<std::vector<reference::PixelBytes>> overLambda(const Scene& scene,
                                                          reference::PixelPlace pixel) override {
        return colorsOverLambda(renderer_, scene, extent, pixel, options_);
    }

private:
    reference::ReferenceRenderer renderer_;
    reference::DrawOptions options_;
    ImageSource images_;
};

} // namespace

std::unique_ptr<Explainer> referencePainter() {
    return std::make_unique<ReferencePainter>();
}

} // namespace texplorer::conform

#include "core/conform/painter.h"

#include "core/conform/feature.h"
#include "core/conform/lambda_range.h"
#include "core/conform/made_files.h"
#include "core/reference/draw.h"

namespace texplorer::conform {

namespace {

class ReferencePainter : public Explainer {
public:
    explicit ReferencePainter(ImageSource images)
        : images_(std::move(images)) {
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
        return colorsOverLambda(renderer_, scene, images_, extent, pixel, options_);
    }
    const ImageSource& images() const override { return images_; }

private:
    reference::ReferenceRenderer renderer_;
    reference::DrawOptions options_;
    ImageSource images_;
};

} // namespace

std::unique_ptr<Explainer> referencePainterWith(const ImageSource& images) {
    return std::make_unique<ReferencePainter>(images);
}

std::unique_ptr<Explainer> referencePainter() {
    return referencePainterWith(madeImages());
}

} // namespace texplorer::conform

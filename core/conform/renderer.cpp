#include "core/conform/renderer.h"

#include "core/conform/feature.h"
#include "core/conform/lambda_range.h"
#include "core/conform/made_files.h"
#include "core/reference/draw.h"

namespace texplorer::conform {

namespace {

class Reference : public Explainer {
public:
    explicit Reference(ImageSource images)
        : images_(std::move(images)) {
        options_.threads = 1;
    }
    Result<Frame> draw(const Scene& scene) override { return renderer_.draw(requestFor(scene), options_); }
    Result<std::vector<reference::PixelBytes>> overLambda(const Scene& scene,
                                                          reference::PixelPlace pixel) override {
        return colorsOverLambda(renderer_, requestFor(scene), pixel, options_);
    }
    const ImageSource& images() const override { return images_; }

private:
    [[nodiscard]] reference::DrawRequest requestFor(const Scene& scene) const {
        return {scene, images_, 0, extent, extent, reference::AnisotropyMethod::Ellipse};
    }

    reference::ReferenceRenderer renderer_;
    reference::DrawOptions options_;
    ImageSource images_;
};

} // namespace

std::unique_ptr<Explainer> referenceRendererWith(const ImageSource& images) {
    return std::make_unique<Reference>(images);
}

std::unique_ptr<Explainer> referenceRenderer() {
    return referenceRendererWith(madeImages());
}

} // namespace texplorer::conform

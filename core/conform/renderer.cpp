#include "texplorer/conform/renderer.h"

#include "texplorer/conform/feature.h"
#include "texplorer/conform/lambda_range.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/reference/draw.h"

namespace texplorer::conform {

namespace {

class Reference : public Explainer {
public:
    Reference(reference::DrawRequest request, unsigned threads)
        : request_(std::move(request)) {
        options_.threads = threads;
    }
    Result<Frame> drawBy(const Scene& scene, reference::RhoMethod rho) override {
        return renderer_.draw(requestFor(scene, rho), options_);
    }
    Result<std::vector<reference::PixelBytes>> overLambda(const Scene& scene, reference::PixelPlace pixel,
                                                          RhoMethods methods) override {
        return colorsOverLambda(renderer_, requestFor(scene, methods.front()), pixel, methods, options_);
    }
    const ImageSource& images() const override { return request_.images; }

private:
    const reference::DrawRequest& requestFor(const Scene& scene, reference::RhoMethod rho) {
        request_.scene = scene;
        request_.rho = rho;
        return request_;
    }

    reference::ReferenceRenderer renderer_;
    reference::DrawOptions options_;
    reference::DrawRequest request_;
};

} // namespace

std::unique_ptr<Explainer> referenceRendererFor(const reference::DrawRequest& as, unsigned threads) {
    return std::make_unique<Reference>(as, threads);
}

std::unique_ptr<Explainer> referenceRendererWith(const ImageSource& images, const Driver& driver) {
    return referenceRendererFor({.scene = {},
                                 .images = images,
                                 .width = extent,
                                 .height = extent,
                                 .anisotropy = driver.anisotropy()});
}

std::unique_ptr<Explainer> referenceRenderer(const Driver& driver) {
    return referenceRendererWith(madeImages(), driver);
}

} // namespace texplorer::conform

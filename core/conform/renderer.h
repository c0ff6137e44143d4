#pragma once

#include "texplorer/base/result.h"
#include "texplorer/conform/pair.h"
#include "texplorer/reference/draw_request.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/scene/frame.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <memory>
#include <span>
#include <vector>

namespace texplorer::conform {

/// A renderer to compare. Draws one scene after the other: frames of extent x extent pixels (feature.h), at
/// time 0.
class Renderer {
public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    virtual ~Renderer() = default;

    [[nodiscard]] virtual Result<Frame> draw(const Scene& scene) = 0;
};

/// Methods to compute rho, any of which a driver may use; at least one.
using RhoMethods = std::span<const reference::RhoMethod>;

/// The reference, which also computes the results that a driver's freedom and precision allow.
class Explainer : public Renderer {
public:
    [[nodiscard]] Result<Frame> draw(const Scene& scene) final {
        return drawBy(scene, reference::RhoMethod::Ideal);
    }
    [[nodiscard]] virtual Result<Frame> drawBy(const Scene& scene, reference::RhoMethod rho) = 0;
    /// The colours of a pixel over the range of lambda: see lambda_range.h.
    [[nodiscard]] virtual Result<std::vector<reference::PixelBytes>>
    overLambda(const Scene& scene, reference::PixelPlace pixel, RhoMethods methods) = 0;
    /// The images that scenes are drawn with.
    [[nodiscard]] virtual const ImageSource& images() const = 0;
};

/// Draws every scene like this request: with its images, time and size.
[[nodiscard]] std::unique_ptr<Explainer> referenceRendererFor(const reference::DrawRequest& as,
                                                              unsigned threads = 1);
/// For the pictures of a sweep. Filters anisotropically like this driver.
[[nodiscard]] std::unique_ptr<Explainer> referenceRendererWith(const ImageSource& images,
                                                               const Driver& driver = {});
/// With the files that the sweep's scenes refer to.
[[nodiscard]] std::unique_ptr<Explainer> referenceRenderer(const Driver& driver = {});

} // namespace texplorer::conform

#pragma once

#include "core/base/result.h"
#include "core/reference/explain/explanation.h"
#include "core/scene/frame.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <memory>
#include <vector>

namespace texplorer::conform {

/// One of the renderers that are compared. Draws one scene after the other: frames of extent x extent pixels
/// (feature.h), at time 0.
class Renderer {
public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    virtual ~Renderer() = default;

    [[nodiscard]] virtual Result<Frame> draw(const Scene& scene) = 0;
};

/// The reference, which can also say what a driver's precision makes of a pixel. On the calling thread alone;
/// anisotropic as Mesa is.
class Explainer : public Renderer {
public:
    /// The colours of a pixel over the error of lambda: see lambda_range.h.
    [[nodiscard]] virtual Result<std::vector<reference::PixelBytes>>
    overLambda(const Scene& scene, reference::PixelPlace pixel) = 0;
    /// Those that scenes are drawn with.
    [[nodiscard]] virtual const ImageSource& images() const = 0;
};

[[nodiscard]] std::unique_ptr<Explainer> referenceRendererWith(const ImageSource& images);
/// With the files that the scenes of the sweep name.
[[nodiscard]] std::unique_ptr<Explainer> referenceRenderer();

} // namespace texplorer::conform

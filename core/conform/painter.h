#pragma once

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/reference/explain/explanation.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <memory>
#include <string>
#include <vector>

namespace texplorer::conform {

struct Painting {
    Image image;                       ///< Rgba8, extent x extent, bottom row first
    std::vector<std::string> problems; ///< sentences: what could not be drawn, or was done otherwise
};

/// One of the renderers that are compared. Draws one scene after the other, at time 0.
class Painter {
public:
    Painter() = default;
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;
    virtual ~Painter() = default;

    [[nodiscard]] virtual Result<Painting> paint(const Scene& scene) = 0;
};

/// The reference, which can also say what a driver's precision makes of a pixel. On the calling thread alone;
/// anisotropic as Mesa is.
class Explainer : public Painter {
public:
    /// The colours of a pixel over the error of lambda: see lambda_range.h.
    [[nodiscard]] virtual Result<std::vector<reference::PixelBytes>>
    overLambda(const Scene& scene, reference::PixelPlace pixel) = 0;
    /// Those that scenes are drawn with.
    [[nodiscard]] virtual const ImageSource& images() const = 0;
};

[[nodiscard]] std::unique_ptr<Explainer> referencePainterWith(const ImageSource& images);
/// With the files that the scenes of the sweep name.
[[nodiscard]] std::unique_ptr<Explainer> referencePainter();

} // namespace texplorer::conform

#pragma once

#include "core/reference/draw.h"
#include "core/reference/explain/explanation.h"
#include "core/reference/raster/triangle.h"
#include "core/reference/sampling/texture_store.h"

namespace texplorer::reference {

/// Why the pixel has the colour that drawReference gives it: nothing else is drawn. Errors: OutOfRange for a
/// bad size or a pixel outside of the picture, TooLarge without memory, Cancelled after a stop request.
/// ReferenceRenderer::probe keeps the textures for the next one.
[[nodiscard]] Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel,
                                        const DrawOptions& options = {});

/// The same for a caller that keeps a TextureStore, and has seen that the picture has the pixel. Error:
/// Cancelled.
[[nodiscard]] Result<Explanation> explainPixel(const DrawRequest& request, PixelPlace pixel,
                                               const DrawOptions& options, TextureStore& textures);

} // namespace texplorer::reference

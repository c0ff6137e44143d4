#pragma once

#include "texplorer/reference/draw.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/texture_store.h"

namespace texplorer::reference {

/// Explains the colour that drawReference gives a pixel, without drawing others. Errors: OutOfRange for an
/// invalid size or a pixel outside of the picture, TooLarge without memory, Cancelled after a stop request.
/// ReferenceRenderer::probe caches the textures.
[[nodiscard]] Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel,
                                        const DrawOptions& options = {});

/// The same for a caller with a TextureStore, who has checked that the pixel exists. Error: Cancelled.
[[nodiscard]] Result<Explanation> explainPixel(const DrawRequest& request, PixelPlace pixel,
                                               const DrawOptions& options, TextureStore& textures);

} // namespace texplorer::reference

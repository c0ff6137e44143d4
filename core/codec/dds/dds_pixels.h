#pragma once

#include "texplorer/codec/dds/dds_format.h"

namespace texplorer::dds {

/// Converts uncompressed pixels to eight bits per component. A channel of n bits becomes round(value * 255 /
/// (2^n - 1)), as OpenGL and Direct3D define it; a missing channel becomes 0. `from` has pixels.bytes() bytes
/// for each pixel of the image.
void unpackPixels(const MaskedPixels& pixels, ByteView from, Image& image);

/// Whether a visible texel has DXT1's code for transparent black. `blocks` are those of a picture of these
/// extents.
[[nodiscard]] bool hasPunchThrough(ByteView blocks, int width, int height, int depth);

} // namespace texplorer::dds

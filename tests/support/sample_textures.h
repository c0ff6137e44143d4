#pragma once

#include "texplorer/codec/registry.h"

namespace texplorer::test {

/// Tiny textures of every kind: each pixel format and block format, odd sizes, mip chains, a cube map, a
/// volume; the same ones each time.
[[nodiscard]] std::vector<TextureImage> sampleTextures();

/// What a row's writer makes of them, in both ways of writing; those that it refuses are left out. Empty for
/// a row without a writer.
[[nodiscard]] std::vector<Bytes> sampleFiles(const CodecRow& row);

} // namespace texplorer::test

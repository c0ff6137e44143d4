#pragma once

#include "texplorer/base/bytes.h"

#include <vector>

namespace texplorer::test {

/// JPEG has no writer of ours: what libjpeg-turbo makes of a small picture, with each subsampling, in grey,
/// and progressive.
[[nodiscard]] std::vector<Bytes> sampleJpegs();

} // namespace texplorer::test

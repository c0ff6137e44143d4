#pragma once

#include "core/gl/block_format.h"

#include <squish.h>

namespace texplorer {

/// libsquish's number for a format; 0 for the signed ones, which it doesn't know.
inline int squishFlag(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
        return squish::kDxt1;
    case BlockFormat::Dxt3:
        return squish::kDxt3;
    case BlockFormat::Dxt5:
        return squish::kDxt5;
    case BlockFormat::Bc4:
        return squish::kBc4;
    case BlockFormat::Bc5:
        return squish::kBc5;
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return 0;
}

} // namespace texplorer

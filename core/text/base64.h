#pragma once

#include "texplorer/base/bytes.h"

#include <string>

namespace texplorer {

/// RFC 4648, section 4, padded with '='.
[[nodiscard]] std::string base64(ByteView bytes);

} // namespace texplorer

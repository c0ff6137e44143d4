#pragma once

#include "texplorer/base/result.h"
#include "texplorer/codec/registry.h"
#include "texplorer/image/texture_image.h"

#include <string>

namespace texplorer::screenshot {

/// Reads and decodes a file, or standard input ("-"), with every layer of an array. What is odd about it and
/// was survived goes to standard error. Errors name the path.
[[nodiscard]] Result<TextureImage> readTexture(const std::string& path);

} // namespace texplorer::screenshot

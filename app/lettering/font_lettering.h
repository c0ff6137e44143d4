#pragma once

#include "texplorer/base/result.h"
#include "texplorer/sheet/lettering.h"

#include <memory>

namespace texplorer {

/// DejaVu Sans, as the panels have it, of 13 to 20 pixels, headings bold: smoothed, fitted to the rows of
/// pixels only, so that letters keep their distances. A letter that the font lacks is its box. The error
/// names the folders where it was looked for.
[[nodiscard]] Result<std::unique_ptr<sheet::Lettering>> openLettering();

} // namespace texplorer

#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/view/picture_texts.h"

namespace texplorer::screenshot {

using view::PictureFacts;

[[nodiscard]] PictureFacts factsOf(const ShotRequest& request, const Shot& shot);

} // namespace texplorer::screenshot

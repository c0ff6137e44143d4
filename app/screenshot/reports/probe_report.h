#pragma once

// What `texshot probe` says, as text and as JSON. Pixels are counted from the top left, as in the PNG.

#include "texplorer/base/result.h"
#include "texplorer/reference/contributions.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/scene/renderer.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::screenshot {

/// The pixel as OpenGL drew it, or why there is none.
struct ReadBack {
    RendererKind renderer = RendererKind::Fixed;
    Result<reference::PixelBytes> bytes;
};

[[nodiscard]] std::string asText(const reference::Explanation& explanation,
                                 const std::vector<ReadBack>& readBacks);
[[nodiscard]] std::string asJson(const reference::Explanation& explanation,
                                 const std::vector<ReadBack>& readBacks);

[[nodiscard]] std::string asText(const reference::Contributions& found,
                                 const reference::TexelQuestion& question);

/// As JSON, to be written piece by piece: a large picture's list would take many times its memory. Ends with
/// the first error of `write`.
[[nodiscard]] Result<void> writeJson(const reference::Contributions& found,
                                     const reference::TexelQuestion& question,
                                     const std::function<Result<void>(std::string_view)>& write);

} // namespace texplorer::screenshot

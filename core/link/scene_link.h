#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

namespace texplorer {

/// The longest link that is made or read.
inline constexpr std::size_t maxLinkBytes = std::size_t{1} << 20;

/// Whether a text is meant as a link to a scene: it begins, after white space, with "texplorer:".
[[nodiscard]] bool isSceneLink(std::string_view text);

/// A scene as a text that one can send: "texplorer:1:", then the scene's JSON, compressed (RFC 1950), in the
/// letters of base64url without padding (RFC 4648, section 5). Files are named, not packed. Errors: TooLarge.
[[nodiscard]] Result<std::string> writeSceneLink(const Scene& scene);

/// White space, as mail programs add it, counts for nothing. Takes no more memory than a scene's file may.
/// Errors: no link, one of a later version, longer than maxLinkBytes, damaged or cut off, more than
/// maxSceneBytes unpacked, and those of parseScene.
[[nodiscard]] Result<Scene> parseSceneLink(std::string_view text);

} // namespace texplorer

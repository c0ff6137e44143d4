#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <string>
#include <string_view>

namespace texplorer {

/// The longest link that is written or read.
inline constexpr std::size_t maxLinkBytes = std::size_t{1} << 20;

/// Whether a text is a link to a scene: it begins, after white space, with "texplorer:", or it is the address
/// of a page (http, https or file) with such a text after its #.
[[nodiscard]] bool isSceneLink(std::string_view text);

/// Writes a scene as a link: "texplorer:1:", then the scene's JSON, compressed (RFC 1950), in base64url
/// without padding (RFC 4648, section 5). Image files are referenced, not included. Errors: TooLarge.
[[nodiscard]] Result<std::string> writeSceneLink(const Scene& scene);

/// Reads a link, also in the address of a page. White space, as mail programs add it, is ignored. Uses no
/// more memory than a scene file can. Errors: not a link, a later version, longer than maxLinkBytes, damaged
/// or truncated, more than maxSceneBytes decompressed, and those of parseScene.
[[nodiscard]] Result<Scene> parseSceneLink(std::string_view text);

} // namespace texplorer

#pragma once

#include <string>
#include <string_view>

namespace texplorer::suite {

/// The name of a file, without its extension, for a case: letters, digits and "-_=.,+@" as they are, "__" for
/// "/", so that those of most names can be read; another name, or a long one, has its beginning and a hash.
/// It is no path, begins with no dot, has at most maxFileNameBytes, and two names have two.
[[nodiscard]] std::string fileNameFor(std::string_view name);
inline constexpr std::size_t maxFileNameBytes = 160;

/// What `{driver}` stands for: the renderer string up to its first " (" or "/", "llvmpipe",
/// "NVIDIA_GeForce_RTX_3080"; "reference" where it is empty. Safe as a file's name.
[[nodiscard]] std::string driverSlug(std::string_view rendererString);

/// Whether a text fits a glob: "*" any characters, "?" one, "[a-z]" one of these, "[!a-z]" one of others, "\"
/// takes the next as it is. A "[" without its "]" is itself. Bytes are compared. The time is at most
/// proportional to the product of both lengths.
[[nodiscard]] bool fitsGlob(std::string_view glob, std::string_view text);

/// --only: fits as a whole, or up to a "/": "bricks" fits "bricks/fixed@512x512" as well.
[[nodiscard]] bool isWanted(std::string_view pattern, std::string_view name);

} // namespace texplorer::suite

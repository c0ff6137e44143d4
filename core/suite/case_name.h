#pragma once

#include <string>
#include <string_view>

namespace texplorer::suite {

/// Returns the name of a case's files, without extension: letters, digits and "-_=.,+@" are kept, "/" becomes
/// "__", so most names stay readable; other and long names are cut and get a hash. The result is not a path,
/// does not begin with a dot, has at most maxFileNameBytes, and differs for different names.
[[nodiscard]] std::string fileNameFor(std::string_view name);
inline constexpr std::size_t maxFileNameBytes = 160;

/// The replacement for `{driver}`: the renderer string up to its first " (" or "/", "llvmpipe",
/// "NVIDIA_GeForce_RTX_3080"; "reference" if it is empty. Safe in file names.
[[nodiscard]] std::string driverSlug(std::string_view rendererString);

/// Whether a text matches a glob: "*" any characters, "?" one, "[a-z]" one of these, "[!a-z]" one of others,
/// "\" quotes the next character. A "[" without "]" matches itself. Compares bytes. The time is at most
/// proportional to the product of both lengths.
[[nodiscard]] bool fitsGlob(std::string_view glob, std::string_view text);

/// --only: matches the whole name, or a beginning before a "/": "bricks" matches "bricks/fixed@512x512" as
/// well.
[[nodiscard]] bool isWanted(std::string_view pattern, std::string_view name);

} // namespace texplorer::suite

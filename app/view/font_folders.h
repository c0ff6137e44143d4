#pragma once

#include <array>

namespace texplorer::view {

/// Where distributions keep DejaVu, in which words are set: Debian, Fedora, Arch.
inline constexpr std::array fontFolders{"/usr/share/fonts/truetype/dejavu/",
                                        "/usr/share/fonts/dejavu-sans-fonts/",
                                        "/usr/share/fonts/dejavu-sans-mono-fonts/", "/usr/share/fonts/TTF/"};

} // namespace texplorer::view

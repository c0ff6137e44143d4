#pragma once

#include <array>

namespace texplorer::view {

/// Where distributions keep DejaVu, in which words are set: Debian, Fedora, Arch.
inline constexpr std::array fontFolders{"/usr/share/fonts/truetype/dejavu/",
                                        "/usr/share/fonts/dejavu-sans-fonts/",
                                        "/usr/share/fonts/dejavu-sans-mono-fonts/", "/usr/share/fonts/TTF/"};

/// A font with Chinese, Japanese and Korean letters. They are to be as large as DejaVu's, which leaves less
/// of a line's height free.
struct ChineseFont {
    const char* file;
    float lineHeight; ///< in its em; DejaVu's is 1.164
};
inline constexpr float dejaVuLineHeight = 1.164F;

/// Debian's fonts-droid-fallback, fonts-wqy-microhei and fonts-noto-cjk, Fedora's and Arch's Noto: the first
/// that is there is taken.
inline constexpr std::array chineseFonts{
    ChineseFont{"/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", 1.309F},
    ChineseFont{"/usr/share/fonts/truetype/wqy/wqy-microhei.ttc", 1.17F},
    ChineseFont{"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 1.448F},
    ChineseFont{"/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc", 1.448F},
    ChineseFont{"/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc", 1.448F}};

} // namespace texplorer::view

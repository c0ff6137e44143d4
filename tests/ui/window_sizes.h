#pragma once

#include <array>

namespace texplorer::test {

/// Windows from a small one to a large screen, in pixels.
struct WindowSize {
    int width, height;
};
inline constexpr std::array windowSizes{WindowSize{640, 480},   WindowSize{800, 600},  WindowSize{1024, 700},
                                        WindowSize{1024, 768},  WindowSize{1280, 800}, WindowSize{1920, 1080},
                                        WindowSize{2560, 1440}, WindowSize{3840, 2160}};

/// Content scales of their monitors.
inline constexpr std::array windowScales{1.0F, 1.5F, 2.0F};

} // namespace texplorer::test

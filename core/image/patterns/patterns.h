#pragma once

// One function per pattern; called only by drawPattern and the tests.

#include "texplorer/image/image.h"

namespace texplorer {

[[nodiscard]] Image drawChecker();
[[nodiscard]] Image drawCheckerRed();
[[nodiscard]] Image drawUvTemplate();
[[nodiscard]] Image drawBrick();
[[nodiscard]] Image drawBrickHeight();
[[nodiscard]] Image drawColorLine();
[[nodiscard]] Image drawTree();
[[nodiscard]] Image drawMipColors();
[[nodiscard]] Image drawMarble();
[[nodiscard]] Image drawCubeFaces();
[[nodiscard]] Image drawPlanet();
[[nodiscard]] Image drawMirrorBall();
[[nodiscard]] Image drawLogoOpenGl();
[[nodiscard]] Image drawLogoMultitexture();
[[nodiscard]] Image drawGradient();

} // namespace texplorer

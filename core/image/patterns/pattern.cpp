#include "texplorer/image/patterns/pattern.h"

#include "texplorer/image/patterns/patterns.h"

namespace texplorer {

Image drawPattern(Pattern pattern) {
    switch (pattern) {
    case Pattern::Checker:
        return drawChecker();
    case Pattern::CheckerRed:
        return drawCheckerRed();
    case Pattern::UvTemplate:
        return drawUvTemplate();
    case Pattern::Brick:
        return drawBrick();
    case Pattern::BrickHeight:
        return drawBrickHeight();
    case Pattern::ColorLine:
        return drawColorLine();
    case Pattern::Tree:
        return drawTree();
    case Pattern::MipColors:
        return drawMipColors();
    case Pattern::Marble:
        return drawMarble();
    case Pattern::CubeFaces:
        return drawCubeFaces();
    case Pattern::Planet:
        return drawPlanet();
    case Pattern::MirrorBall:
        return drawMirrorBall();
    case Pattern::LogoOpenGl:
        return drawLogoOpenGl();
    case Pattern::LogoMultitexture:
        return drawLogoMultitexture();
    case Pattern::Gradient:
        return drawGradient();
    }
    return drawChecker();
}

} // namespace texplorer

#pragma once

// Programs as in textbooks: OpenGL with glBegin and glEnd, GLU and glTexEnv, without code of Texplorer. Each
// draws the scene of its name in assets/scenes.

#include <cstdint>
#include <string_view>
#include <vector>

namespace texplorer::programs {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels; ///< red, green, blue, alpha; the bottom row first
};

/// A picture that a program shares with its scene, by the name of the pattern. Defined by the users of the
/// programs.
[[nodiscard]] const Picture& pattern(std::string_view name);

// Each clears the current framebuffer of this size and draws into it. Expects a context in OpenGL's initial
// state; the caller restores that state.

void drawChecker(int width, int height);
void drawTexbind(int width, int height);
void drawLine(int width, int height);
void drawSpiral(int width, int height);
void drawQuadrics(int width, int height);
void drawEarthNearest(int width, int height);
void drawEarthLinear(int width, int height);
void drawPackedPixels(int width, int height);
void drawTexsub(int width, int height);
void drawNeheNoBumps(int width, int height);
void drawNeheBumpsOneUnit(int width, int height);
void drawNeheBumpsTwoUnits(int width, int height);

} // namespace texplorer::programs

#pragma once

// Programs as textbooks have them: OpenGL from glBegin to glEnd, GLU and glTexEnv, and nothing of ours. Each
// draws what the scene of its name in assets/scenes shows.

#include <cstdint>
#include <string_view>
#include <vector>

namespace texplorer::programs {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels; ///< red, green, blue, alpha; the bottom row first
};

/// A picture that a program shares with its scene, by the name of the pattern. Whoever runs the programs
/// defines this.
[[nodiscard]] const Picture& pattern(std::string_view name);

// Each clears the current framebuffer of this size and draws into it. The context has OpenGL's initial state,
// and gets it back from the caller.

void drawChecker(int width, int height);
void drawTexbind(int width, int height);
void drawLine(int width, int height);
void drawSpiral(int width, int height);
void drawQuadrics(int width, int height);
void drawEarthNearest(int width, int height);
void drawEarthLinear(int width, int height);
void drawNeheNoBumps(int width, int height);
void drawNeheBumpsOneUnit(int width, int height);
void drawNeheBumpsTwoUnits(int width, int height);

} // namespace texplorer::programs

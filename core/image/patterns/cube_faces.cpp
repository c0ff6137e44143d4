#include "texplorer/image/cube_faces.h"

#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"
#include "texplorer/image/patterns/pixel_font.h"

#include <array>

namespace texplorer {

namespace {

constexpr int faceSize = 128;
constexpr Color faceInk{24, 28, 36, 255};
constexpr Color paper{255, 255, 255, 255};

struct Painted {
    std::string_view name;
    Color color;
    int column; // of the cross, from the lower left
    int row;
};

// Opposite faces have complementary colours: x is red, y green, z blue.
constexpr std::array<Painted, cubeFaceCount> painted{{{"+X", {232, 72, 72, 255}, 2, 1},
                                                      {"-X", {72, 208, 208, 255}, 0, 1},
                                                      {"+Y", {72, 196, 88, 255}, 1, 2},
                                                      {"-Y", {212, 92, 208, 255}, 1, 0},
                                                      {"+Z", {84, 116, 236, 255}, 1, 1},
                                                      {"-Z", {236, 208, 72, 255}, 3, 1}}};

/// Squares of eight to a side, a frame, the name, and which way s and t grow.
void drawFace(Canvas& canvas, const Painted& face) {
    const int left = face.column * faceSize;
    const int low = face.row * faceSize;
    for (int y = 0; y < faceSize; ++y) {
        for (int x = 0; x < faceSize; ++x) {
            const bool light = (x / (faceSize / 8) + y / (faceSize / 8)) % 2 == 0;
            const bool frame = x < 2 || y < 2 || x >= faceSize - 2 || y >= faceSize - 2;
            canvas.set(left + x, low + y, frame ? paper : light ? mix(face.color, paper, 0.18F) : face.color);
        }
    }
    constexpr int scale = 7;
    const int width = textWidth(face.name) * scale;
    drawText(canvas, left + (faceSize - width) / 2, low + (faceSize - glyphHeight * scale) / 2 - 10, scale,
             face.name, faceInk);
    // From the upper left corner, where s and t are 0.
    const int top = low + faceSize - 1;
    for (int along = 8; along < 40; ++along) {
        const int half = along < 30 ? 1 : (40 - along) / 2;
        for (int across = -half; across <= half; ++across) {
            canvas.set(left + along, top - 9 + across, faceInk);
            canvas.set(left + 9 + across, top - along, faceInk);
        }
    }
    drawText(canvas, left + 43, top - 16, 2, "s", faceInk);
    drawText(canvas, left + 5, top - 57, 2, "t", faceInk);
}

} // namespace

// Unfolded, so that the picture shows what it is wherever it is shown flat.
Image drawCubeFaces() {
    Canvas canvas(4 * faceSize, 3 * faceSize);
    canvas.fill(0, 0, 4 * faceSize, 3 * faceSize, {48, 52, 60, 255});
    for (const Painted& face : painted)
        drawFace(canvas, face);
    return std::move(canvas).take();
}

} // namespace texplorer

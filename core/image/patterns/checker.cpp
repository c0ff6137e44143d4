#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/patterns.h"

namespace texplorer {

namespace {

// The programs index image[i][j] with i as the row; both boards begin dark at the lower left corner.
Image drawBoard(int square, Color light) {
    constexpr int size = 64;
    Canvas canvas(size, size);
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const bool isLight = ((i & square) == 0) != ((j & square) == 0);
            canvas.set(j, i, isLight ? light : Color{0, 0, 0, 255});
        }
    return std::move(canvas).take();
}

} // namespace

Image drawChecker() {
    return drawBoard(8, {255, 255, 255, 255});
}

Image drawCheckerRed() {
    return drawBoard(16, {255, 0, 0, 255});
}

} // namespace texplorer

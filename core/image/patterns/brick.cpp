#include "texplorer/image/patterns/canvas.h"
#include "texplorer/image/patterns/noise.h"
#include "texplorer/image/patterns/patterns.h"

#include <algorithm>
#include <vector>

namespace texplorer {

namespace {

// A running bond: every second course is shifted by half a brick. Courses and bricks divide the brickSize, so
// it tiles.
constexpr int brickSize = 256;
constexpr int brickWidth = 64;
constexpr int courseHeight = 32;
constexpr int joint = 4; // width of the mortar between two bricks, in texels
constexpr int bevel = 4; // over how many texels a brick's edge rises
constexpr float mortarLevel = 0.22F;

struct Place {
    int brick;  ///< its number in the course
    int course; ///< from the bottom
    int edge;   ///< texels to the nearest edge of the brick; negative in the mortar
};

Place placeAt(int x, int y) {
    const int course = y / courseHeight;
    const int shifted = (x + (course % 2) * brickWidth / 2) % brickSize;
    const int inX = shifted % brickWidth;
    const int inY = y % courseHeight;
    const int toSide = std::min(inX - joint / 2, brickWidth - 1 - joint / 2 - inX);
    const int toLid = std::min(inY - joint / 2, courseHeight - 1 - joint / 2 - inY);
    return {shifted / brickWidth, course, std::min(toSide, toLid)};
}

float grain(int x, int y, int cells, std::uint32_t seed) {
    const float scale = static_cast<float>(cells) / brickSize;
    return tiledTurbulence(static_cast<float>(x) * scale, static_cast<float>(y) * scale, 0, cells, seed);
}

// 0 is deepest, 1 stands out furthest.
float heightAt(int x, int y) {
    const Place place = placeAt(x, y);
    const float fine = grain(x, y, 32, 1);
    const float mortar = mortarLevel + 0.12F * (fine - 0.5F);
    // Worn edges: the noise moves the outline by about a texel.
    const float edge = static_cast<float>(place.edge) + 0.5F + 3.0F * (grain(x, y, 16, 2) - 0.5F);
    if (edge <= 0)
        return mortar;
    const float top = 0.78F + 0.14F * hash01(place.brick, place.course, 0, 3) + 0.16F * (fine - 0.5F);
    const float rise = std::min(edge / bevel, 1.0F);
    return mortar + (top - mortar) * (1 - (1 - rise) * (1 - rise));
}

class HeightMap {
public:
    HeightMap()
        : heights_(static_cast<std::size_t>(brickSize) * brickSize) {
        for (int y = 0; y < brickSize; ++y)
            for (int x = 0; x < brickSize; ++x)
                heights_[index(x, y)] = heightAt(x, y);
    }

    /// Coordinates just outside of the image wrap around.
    [[nodiscard]] float at(int x, int y) const {
        return heights_[index((x + brickSize) % brickSize, (y + brickSize) % brickSize)];
    }

private:
    static std::size_t index(int x, int y) {
        return static_cast<std::size_t>(y) * brickSize + static_cast<std::size_t>(x);
    }

    std::vector<float> heights_;
};

Color colorAt(const HeightMap& heights, int x, int y) {
    const Place place = placeAt(x, y);
    const float height = heights.at(x, y);
    const float tone = hash01(place.brick, place.course, 0, 4);
    const float warmth = hash01(place.brick, place.course, 0, 5);
    Color brick = mix({126, 50, 38, 255}, {186, 92, 62, 255}, tone);
    brick = mix(brick, {152, 72, 72, 255}, 0.45F * warmth);
    brick = shade(brick, 0.82F + 0.36F * grain(x, y, 8, 6));
    const Color mortar = shade({186, 178, 164, 255}, 0.86F + 0.28F * grain(x, y, 64, 7));
    const Color surface = mix(mortar, brick, (height - mortarLevel - 0.08F) / 0.12F);
    // Light from the upper left, as if the heights were a relief, and less of it down in the joints.
    const float slope =
        (heights.at(x + 1, y) - heights.at(x - 1, y)) + (heights.at(x, y - 1) - heights.at(x, y + 1));
    return shade(surface, std::clamp(0.80F + 0.26F * height + 0.42F * slope, 0.4F, 1.35F));
}

} // namespace

Image drawBrick() {
    const HeightMap heights;
    Canvas canvas(brickSize, brickSize);
    for (int y = 0; y < brickSize; ++y)
        for (int x = 0; x < brickSize; ++x)
            canvas.set(x, y, colorAt(heights, x, y));
    return std::move(canvas).take();
}

Image drawBrickHeight() {
    Canvas canvas(brickSize, brickSize);
    for (int y = 0; y < brickSize; ++y)
        for (int x = 0; x < brickSize; ++x) {
            const std::uint8_t grey = toByte(255 * heightAt(x, y));
            canvas.set(x, y, {grey, grey, grey, 255});
        }
    return std::move(canvas).take();
}

} // namespace texplorer

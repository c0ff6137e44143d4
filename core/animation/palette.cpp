#include "texplorer/animation/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_set>

namespace texplorer::animation {
namespace {

constexpr int side = 33; ///< 32 cells on each axis; what lies before the first is 0
constexpr int refinements = 3;

constexpr int redOf(std::uint32_t pixel) {
    return static_cast<int>(pixel >> 16U & 0xFFU);
}
constexpr int greenOf(std::uint32_t pixel) {
    return static_cast<int>(pixel >> 8U & 0xFFU);
}
constexpr int blueOf(std::uint32_t pixel) {
    return static_cast<int>(pixel & 0xFFU);
}

/// Of pixels: how many, the sum of each colour, and of all squares.
struct Sums {
    double count = 0;
    std::array<double, 3> colors{};
    double squares = 0;

    Sums& operator+=(const Sums& other) { return add(other, 1); }
    Sums& operator-=(const Sums& other) { return add(other, -1); }
    Sums& add(const Sums& other, double times) {
        count += times * other.count;
        for (std::size_t i = 0; i < 3; ++i)
            colors[i] += times * other.colors[i];
        squares += times * other.squares;
        return *this;
    }

    /// What a mean in the place of the pixels leaves of their squares: the larger, the smaller the error.
    [[nodiscard]] double kept() const {
        return count > 0 ? (colors[0] * colors[0] + colors[1] * colors[1] + colors[2] * colors[2]) / count
                         : 0;
    }
    [[nodiscard]] double error() const { return squares - kept(); }
    [[nodiscard]] std::uint32_t mean() const {
        const auto part = [&](std::size_t i) { return static_cast<std::uint32_t>(colors[i] / count + 0.5); };
        return 0xFF000000U | part(0) << 16U | part(1) << 8U | part(2);
    }
};

/// Cells on each axis, the last one included, the one before the first not.
struct Box {
    std::array<int, 3> before{};
    std::array<int, 3> last{32, 32, 32};
};

class ColorCube {
public:
    explicit ColorCube(std::span<const std::uint32_t> pixels)
        : cells_(std::size_t{side} * side * side) {
        for (const std::uint32_t pixel : pixels) {
            const int red = redOf(pixel);
            const int green = greenOf(pixel);
            const int blue = blueOf(pixel);
            Sums& cell = cells_[indexOf(red / 8 + 1, green / 8 + 1, blue / 8 + 1)];
            cell.count += 1;
            cell.colors[0] += red;
            cell.colors[1] += green;
            cell.colors[2] += blue;
            cell.squares += red * red + green * green + blue * blue;
        }
        for (const Sums& cell : cells_)
            if (cell.count > 0)
                filled_.push_back(cell);
        accumulate();
    }

    /// Cells with pixels.
    [[nodiscard]] const std::vector<Sums>& filled() const { return filled_; }

    [[nodiscard]] Sums in(const Box& box) const {
        const auto& [b, l] = box;
        Sums sums = at(l[0], l[1], l[2]);
        sums -= at(b[0], l[1], l[2]);
        sums -= at(l[0], b[1], l[2]);
        sums -= at(l[0], l[1], b[2]);
        sums += at(b[0], b[1], l[2]);
        sums += at(b[0], l[1], b[2]);
        sums += at(l[0], b[1], b[2]);
        sums -= at(b[0], b[1], b[2]);
        return sums;
    }

private:
    static std::size_t indexOf(int red, int green, int blue) {
        return static_cast<std::size_t>((red * side + green) * side + blue);
    }
    [[nodiscard]] const Sums& at(int red, int green, int blue) const {
        return cells_[indexOf(red, green, blue)];
    }

    /// Each cell becomes the sum of all that aren't behind it on any axis.
    void accumulate() {
        for (int red = 1; red < side; ++red)
            for (int green = 1; green < side; ++green)
                for (int blue = 1; blue < side; ++blue) {
                    Sums& cell = cells_[indexOf(red, green, blue)];
                    cell += at(red - 1, green, blue);
                    cell += at(red, green - 1, blue);
                    cell += at(red, green, blue - 1);
                    cell -= at(red - 1, green - 1, blue);
                    cell -= at(red - 1, green, blue - 1);
                    cell -= at(red, green - 1, blue - 1);
                    cell += at(red - 1, green - 1, blue - 1);
                }
    }

    std::vector<Sums> cells_;
    std::vector<Sums> filled_;
};

/// The half before the best cut; a box that can't be cut gives nothing and stays.
bool cutInTwo(const ColorCube& cube, Box& box, Box& half) {
    const Sums whole = cube.in(box);
    double best = whole.kept();
    bool found = false;
    Box first;
    Box second;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int cut = box.before[axis] + 1; cut < box.last[axis]; ++cut) {
            Box low = box;
            low.last[axis] = cut;
            const Sums part = cube.in(low);
            Sums rest = whole;
            rest -= part;
            if (part.count < 0.5 || rest.count < 0.5 || part.kept() + rest.kept() <= best)
                continue;
            best = part.kept() + rest.kept();
            first = low;
            second = box;
            second.before[axis] = cut;
            found = true;
        }
    if (!found)
        return false;
    half = first;
    box = second;
    return true;
}

Palette cutPalette(const ColorCube& cube, std::size_t maxColors) {
    std::vector<Box> boxes{Box{}};
    std::vector<double> errors{cube.in(boxes[0]).error()};
    while (boxes.size() < maxColors) {
        const auto worst = std::ranges::max_element(errors);
        if (*worst <= 0)
            break;
        const auto index = static_cast<std::size_t>(worst - errors.begin());
        Box half;
        if (!cutInTwo(cube, boxes[index], half)) {
            errors[index] = 0;
            continue;
        }
        errors[index] = cube.in(boxes[index]).error();
        boxes.push_back(half);
        errors.push_back(cube.in(half).error());
    }
    Palette palette;
    for (const Box& box : boxes)
        palette.push_back(cube.in(box).mean());
    return palette;
}

/// Lloyd's algorithm over the cells: each goes to the nearest colour, and that to the middle of its cells.
void refine(Palette& palette, const std::vector<Sums>& cells) {
    for (int round = 0; round < refinements; ++round) {
        NearestColor nearest(palette);
        std::vector<Sums> gathered(palette.size());
        for (const Sums& cell : cells) {
            const std::uint32_t mean = cell.mean();
            gathered[nearest.of(redOf(mean), greenOf(mean), blueOf(mean))] += cell;
        }
        for (std::size_t i = 0; i < palette.size(); ++i)
            if (gathered[i].count > 0)
                palette[i] = gathered[i].mean();
    }
}

} // namespace

Palette paletteFor(std::span<const std::uint32_t> pixels, std::size_t maxColors) {
    std::unordered_set<std::uint32_t> own;
    std::uint32_t last = 0; // which no pixel is
    for (const std::uint32_t pixel : pixels) {
        if (pixel == last)
            continue;
        last = pixel;
        own.insert(pixel);
        if (own.size() > maxColors)
            break;
    }
    if (own.size() <= maxColors) {
        Palette palette(own.begin(), own.end());
        std::ranges::sort(palette); // the same file from the same pictures
        return palette;
    }
    const ColorCube cube(pixels);
    Palette palette = cutPalette(cube, maxColors);
    refine(palette, cube.filled());
    std::ranges::sort(palette);
    const auto [rest, end] = std::ranges::unique(palette);
    palette.erase(rest, end);
    return palette;
}

NearestColor::NearestColor(const Palette& palette)
    : cells_(std::size_t{64} * 64 * 64, -1) {
    for (const std::uint32_t each : palette)
        colors_.push_back({redOf(each), greenOf(each), blueOf(each)});
}

std::size_t NearestColor::search(int red, int green, int blue) const {
    int least = std::numeric_limits<int>::max();
    std::size_t found = 0;
    for (std::size_t i = 0; i < colors_.size(); ++i) {
        const int r = colors_[i].red - red;
        const int g = colors_[i].green - green;
        const int b = colors_[i].blue - blue;
        const int distance = r * r + g * g + b * b;
        if (distance < least) {
            least = distance;
            found = i;
        }
    }
    return found;
}

std::size_t NearestColor::of(int red, int green, int blue) {
    const auto index = static_cast<std::size_t>((red / 4 * 64 + green / 4) * 64 + blue / 4);
    std::int16_t& known = cells_[index];
    if (known < 0)
        known = static_cast<std::int16_t>(search(red / 4 * 4 + 2, green / 4 * 4 + 2, blue / 4 * 4 + 2));
    return static_cast<std::size_t>(known);
}

} // namespace texplorer::animation

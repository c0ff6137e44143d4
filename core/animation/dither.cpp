#include "texplorer/animation/dither.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace texplorer::animation {
namespace {

constexpr std::size_t maxEntries = 256;

// How much of the error goes on. With all of it, flat ground between two colours comes out right on average
// and noisy; with none of it, in bands.
constexpr int passedOn = 12; // of 16

/// The pixels in a rectangle that aren't those of the picture before.
std::vector<std::uint32_t> changedPixels(const OpaqueFrame& now, const OpaqueFrame* before,
                                         const FrameRect& rect) {
    std::vector<std::uint32_t> pixels;
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const std::uint32_t* row = now.row(y);
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            if (!before || before->row(y)[x] != row[x])
                pixels.push_back(row[x]);
    }
    return pixels;
}

/// Of the three colours, in sixteenths.
using ColorError = std::array<int, 3>;

class Diffusion {
public:
    explicit Diffusion(int width)
        : here_(static_cast<std::size_t>(width) + 2)
        , below_(static_cast<std::size_t>(width) + 2) {}

    /// What has come to a pixel of this row, in whole values.
    [[nodiscard]] int at(int x, std::size_t color) const {
        const int sum = here_[static_cast<std::size_t>(x) + 1][color];
        return (sum + (sum < 0 ? -128 : 128)) / 256;
    }
    void pass(int x, int way, const ColorError& lost) {
        const auto place = [x](int by) { return static_cast<std::size_t>(x + 1 + by); };
        for (std::size_t i = 0; i < 3; ++i) {
            const int part = lost[i] * passedOn;
            here_[place(way)][i] += part * 7;
            below_[place(-way)][i] += part * 3;
            below_[place(0)][i] += part * 5;
            below_[place(way)][i] += part;
        }
    }
    void nextRow() {
        std::swap(here_, below_);
        std::ranges::fill(below_, ColorError{});
    }

private:
    std::vector<ColorError> here_;
    std::vector<ColorError> below_;
};

class Ditherer {
public:
    Ditherer(const OpaqueFrame& now, const OpaqueFrame* before, IndexedPicture& picture)
        : now_(now)
        , before_(before)
        , picture_(picture)
        , nearest_(picture.palette)
        , diffusion_(picture.rect.width) {}

    void run() {
        for (int y = 0; y < picture_.rect.height; ++y) {
            const int way = y % 2 == 0 ? 1 : -1;
            for (int i = 0; i < picture_.rect.width; ++i)
                put(way > 0 ? i : picture_.rect.width - 1 - i, y, way);
            diffusion_.nextRow();
        }
    }

private:
    void put(int x, int y, int way) {
        const FrameRect& rect = picture_.rect;
        const std::uint32_t pixel = now_.row(rect.y + y)[rect.x + x];
        std::uint8_t& index =
            picture_.indices[static_cast<std::size_t>(y) * static_cast<std::size_t>(rect.width) +
                             static_cast<std::size_t>(x)];
        if (before_ && before_->row(rect.y + y)[rect.x + x] == pixel) {
            index = *picture_.nothing;
            return;
        }
        ColorError wanted;
        for (std::size_t i = 0; i < 3; ++i) {
            const int own = static_cast<int>(pixel >> (16U - 8U * i) & 0xFFU);
            wanted[i] = std::clamp(own + diffusion_.at(x, i), 0, 255);
        }
        const std::size_t found = nearest_.of(wanted[0], wanted[1], wanted[2]);
        index = static_cast<std::uint8_t>(found);
        ColorError lost;
        for (std::size_t i = 0; i < 3; ++i)
            lost[i] = wanted[i] - static_cast<int>(picture_.palette[found] >> (16U - 8U * i) & 0xFFU);
        diffusion_.pass(x, way, lost);
    }

    const OpaqueFrame& now_;
    const OpaqueFrame* before_;
    IndexedPicture& picture_;
    NearestColor nearest_;
    Diffusion diffusion_;
};

/// Where every pixel has its own colour in the palette.
void lookUp(const OpaqueFrame& now, const OpaqueFrame* before, IndexedPicture& picture) {
    std::unordered_map<std::uint32_t, std::uint8_t> numbers;
    for (std::size_t i = 0; i < picture.palette.size(); ++i)
        numbers.emplace(picture.palette[i], static_cast<std::uint8_t>(i));
    const FrameRect& rect = picture.rect;
    std::uint8_t* to = picture.indices.data();
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) {
            const std::uint32_t pixel = now.row(y)[x];
            *to++ = before && before->row(y)[x] == pixel ? *picture.nothing : numbers.at(pixel);
        }
}

} // namespace

IndexedPicture indexed(const OpaqueFrame& now, const OpaqueFrame* before) {
    IndexedPicture picture;
    picture.rect = FrameRect{0, 0, now.width, now.height};
    if (before)
        picture.rect = changedRect(*before, now).value_or(FrameRect{0, 0, 1, 1});
    const auto area =
        static_cast<std::size_t>(picture.rect.width) * static_cast<std::size_t>(picture.rect.height);
    const std::vector<std::uint32_t> pixels = changedPixels(now, before, picture.rect);
    const bool keeps = pixels.size() < area;
    picture.palette = paletteFor(pixels, maxEntries - (keeps ? 1 : 0));
    if (keeps)
        picture.nothing = static_cast<std::uint8_t>(picture.palette.size());
    picture.indices.resize(area);
    const std::vector<std::uint32_t>& sorted = picture.palette;
    const bool exact = std::ranges::all_of(
        pixels, [&](std::uint32_t pixel) { return std::ranges::binary_search(sorted, pixel); });
    if (exact)
        lookUp(now, before, picture);
    else
        Ditherer(now, before, picture).run();
    return picture;
}

} // namespace texplorer::animation

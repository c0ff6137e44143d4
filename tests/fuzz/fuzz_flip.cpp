// Flips of compressed blocks. An input is |format|flip|width|height|depth|blocks, repeated until there are
// enough|.

#include "tests/fuzz/broken.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"

#include <algorithm>
#include <cstring>

using namespace texplorer;

namespace {

struct Flip {
    Result<void> (*flip)(BlockImage&);
    bool vertical;
    bool horizontal;
};

constexpr Flip flips[] = {
    {flipVertically, true, false},
    {flipHorizontally, false, true},
    {rotateHalfTurn, true, true},
};

BlockImage blockImage(ByteView input) {
    const auto number = [&](std::size_t index) { return std::to_integer<unsigned>(input[index]); };
    const auto format = static_cast<BlockFormat>(blockFormatRows[number(0) % blockFormatRows.size()].value);
    BlockImage image =
        BlockImage::uninitialised(format, static_cast<int>(1 + number(2) % 70),
                                  static_cast<int>(1 + number(3) % 70), static_cast<int>(1 + number(4) % 3));
    const ByteView source = input.subspan(5);
    for (std::size_t i = 0; i < image.blocks.size(); ++i)
        image.blocks[i] = source.empty() ? std::byte(i * 7) : source[i % source.size()];
    return image;
}

/// The pixels where the flip should have brought them.
Image flipped(const Image& from, const Flip& flip) {
    Image to = from;
    for (int z = 0; z < from.depth; ++z)
        for (int y = 0; y < from.height; ++y)
            for (int x = 0; x < from.width; ++x)
                std::ranges::copy(from.at(flip.horizontal ? from.width - 1 - x : x,
                                          flip.vertical ? from.height - 1 - y : y, z),
                                  to.at(x, y, z).begin());
    return to;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 5)
        return 0;
    const Flip& flip = flips[data[1] % std::size(flips)];
    const BlockImage original = blockImage(std::as_bytes(std::span(data, size)));
    BlockImage image = original;
    const Result<void> done = flip.flip(image);
    const bool lossless = (!flip.vertical || flipsWithoutLoss(image.height)) &&
                          (!flip.horizontal || flipsWithoutLoss(image.width));
    if (done.has_value() != lossless)
        fuzz::broken(done ? "a flip that can't be lossless was made" : done.error().message.english());
    if (!done) {
        if (done.error().message.empty() || image != original)
            fuzz::broken("a refused flip says nothing or changes the blocks");
        return 0;
    }
    if (decodeBlocks(image) != flipped(decodeBlocks(original), flip))
        fuzz::broken("the flipped blocks show another picture");
    static_cast<void>(flip.flip(image));
    if (image != original)
        fuzz::broken("flipping twice changes the blocks");
    return 0;
}

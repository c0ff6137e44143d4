#include "texplorer/s3tc/flip_steps.h"

#include "texplorer/s3tc/block_flip.h"
#include "texplorer/s3tc/flip.h"

#include <utility>

namespace texplorer {
namespace {

/// Turns the first rows of both runs of blocks around while they change places; none where `rows` is 1.
BlockImage swapped(BlockImage image, int rows, std::size_t first, std::size_t second) {
    const std::size_t bytes = image.blockRowBytes();
    std::byte* blocks = image.blocks.data();
    swapFlippedPlain(BlockFlip(image.format, rows, 1), blocks + first * bytes, blocks + second * bytes,
                     bytes);
    return image;
}

} // namespace

Result<std::vector<FlipStep>> flipSteps(const BlockImage& image, EncodeQuality quality) {
    if (const Result<void> sound = checkBlocks(image); !sound)
        return fail(sound.error());
    using Act = FlipStep::Act;
    std::vector<FlipStep> steps{{Act::AsStored, 0, 0, image}};
    const std::size_t blockRows = image.blockRows();
    for (std::size_t low = 0, high = blockRows - 1; low < high; ++low, --high)
        steps.push_back({Act::SwapBlockRows, static_cast<int>(low), static_cast<int>(high),
                         swapped(steps.back().after, 1, low, high)});
    const int rows = turnedRows(image.height);
    for (std::size_t row = 0; rows > 1 && row < blockRows; ++row)
        steps.push_back({Act::TurnRows, static_cast<int>(row), static_cast<int>(row),
                         swapped(steps.back().after, rows, row, row)});
    if (flipsWithoutLoss(image.height))
        return steps;
    Result<BlockImage> again = decodeFlipEncode(image, FlipAxis::Vertical, quality);
    if (!again)
        return fail(again.error());
    steps.push_back({Act::Recompress, 0, 0, *std::move(again)});
    return steps;
}

} // namespace texplorer

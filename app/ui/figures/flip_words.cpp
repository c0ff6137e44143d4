#include "app/ui/figures/block_flip.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"

#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

using Act = FlipStep::Act;

/// The bytes, for 2, 3 and 4 rows of a block.
constexpr std::array<const char*, 3> bytesOfDxt1{
    N_("Swap rows 0 and 1: bytes 4 and 5."), N_("Swap rows 0 and 2: bytes 4 and 6."),
    N_("Swap rows 0 and 3, and 1 and 2: bytes 4 and 7, 5 and 6.")};
constexpr std::array<const char*, 3> bytesOfDxt3{
    N_("Swap rows 0 and 1: bytes 0, 1 and 2, 3 of the alphas; bytes 12 and 13 of the indices."),
    N_("Swap rows 0 and 2: bytes 0, 1 and 4, 5 of the alphas; bytes 12 and 14 of the indices."),
    N_("Swap rows 0 and 3, and 1 and 2: bytes 0, 1 and 6, 7, then 2, 3 and 4, 5 of the alphas; bytes 12 and "
       "15, 13 and 14 of the indices.")};
constexpr std::array<const char*, 3> bytesOfDxt5{
    N_("Swap rows 0 and 1: the first and the second 12 bits of the alphas; bytes 12 and 13."),
    N_("Swap rows 0 and 2: the first and the third 12 bits of the alphas; bytes 12 and 14."),
    N_("Swap rows 0 and 3, and 1 and 2: their 12 bits of the alphas; bytes 12 and 15, 13 and 14.")};

const char* bytesThatMove(BlockFormat format, int rows) {
    const auto& words = format == BlockFormat::Dxt5   ? bytesOfDxt5
                        : format == BlockFormat::Dxt3 ? bytesOfDxt3
                                                      : bytesOfDxt1;
    return words.at(static_cast<std::size_t>(rows - 2));
}

/// The error of recompression against the mirrored picture, over all components.
double errorOf(const BlockImage& stored, const BlockImage& again) {
    Image expected = decodeBlocks(stored);
    flipVertically(expected);
    const Image found = decodeBlocks(again);
    double sum = 0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
        const double apart = std::to_integer<int>(expected.pixels[i]) - std::to_integer<int>(found.pixels[i]);
        sum += apart * apart;
    }
    return std::sqrt(sum / static_cast<double>(expected.pixels.size()));
}

std::vector<Sentence> beginning(const BlockImage& image) {
    const int height = image.height;
    std::vector<Sentence> words{N_(
        "As in the file: the first row is the top row of the image, but OpenGL takes it for the bottom row.")};
    if (height == 1)
        words.emplace_back(N_("There is only one row: nothing to do."));
    else if (height < 4)
        words.push_back({N_("One row of blocks, of which {0} texel rows are inside the image."), height});
    else if (!flipsWithoutLoss(height))
        words.push_back(
            {N_("A height of {0} is not a multiple of 4: the last block is used in part. Continue "
                "to see the result of the usual steps."),
             height});
    return words;
}

std::vector<Sentence> turning(std::span<const FlipStep> steps, std::size_t step) {
    const BlockImage& image = steps[step].after;
    const int rows = turnedRows(image.height);
    std::vector<Sentence> words{Sentence("Inside the blocks of row {0}.", steps[step].first),
                                bytesThatMove(image.format, rows)};
    if (rows < 4)
        words.emplace_back(N_("The rows outside the image keep their bits."));
    const bool isLastTurn = step + 1 == steps.size() || steps[step + 1].act == Act::Recompress;
    if (!isLastTurn)
        return words;
    if (flipsWithoutLoss(image.height))
        words.emplace_back(N_("Done: the image is upside down, and no colour has changed."));
    else
        words.push_back(
            {N_("Wrong: the image begins with {0} unused rows, and has lost as many rows of its own."),
             4 - image.height % 4});
    return words;
}

} // namespace

std::vector<Sentence> flipSentences(std::span<const FlipStep> steps, std::size_t step) {
    const FlipStep& now = steps[step];
    switch (now.act) {
    case Act::AsStored:
        return beginning(now.after);
    case Act::SwapBlockRows: {
        std::vector<Sentence> words{Sentence(
            "Swap the rows of blocks {0} and {1}, with each block unchanged.", now.first, now.second)};
        if (now.second - now.first == 2)
            words.emplace_back(N_("The middle row stays in place."));
        return words;
    }
    case Act::TurnRows:
        return turning(steps, step);
    case Act::Recompress:
        break;
    }
    return {
        N_("A new block would need rows of two old blocks, but has only two end colours for all of them."),
        Sentence("Decompressed, flipped and compressed again, it differs by {0:.1f} of 255 (RMS).",
                 errorOf(steps.front().after, now.after)),
        N_("Texplorer decompresses such a texture at loading and flips its pixels; texshot flip refuses it "
           "without --lossy.")};
}

} // namespace texplorer::ui

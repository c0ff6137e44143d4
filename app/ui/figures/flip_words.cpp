#include "app/ui/figures/flip_words.h"

#include "core/image/texture_image.h"
#include "core/s3tc/block_parts.h"
#include "core/s3tc/decode.h"
#include "core/s3tc/flip.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

using Act = FlipStep::Act;

constexpr std::array pairsOfTwo{RowPair{0, 1}};
constexpr std::array pairsOfThree{RowPair{0, 2}};
constexpr std::array pairsOfFour{RowPair{0, 3}, RowPair{1, 2}};

/// Which bytes that are: for 2, 3 and 4 rows of a block.
constexpr std::array<const char*, 3> bytesOfDxt1{
    "Rows 0 and 1 change places: bytes 4 and 5.", "Rows 0 and 2 change places: bytes 4 and 6.",
    "Rows 0 and 3 change places, and 1 and 2: bytes 4 and 7, 5 and 6."};
constexpr std::array<const char*, 3> bytesOfDxt3{
    "Rows 0 and 1 change places: of the alphas bytes 0, 1 and 2, 3; of the indices 12 and 13.",
    "Rows 0 and 2 change places: of the alphas bytes 0, 1 and 4, 5; of the indices 12 and 14.",
    "Rows 0 and 3 change places, and 1 and 2: of the alphas bytes 0, 1 and 6, 7, then 2, 3 and 4, 5; of the "
    "indices 12 and 15, 13 and 14."};
constexpr std::array<const char*, 3> bytesOfDxt5{
    "Rows 0 and 1 change places: the first and the second 12 bits of the alphas; bytes 12 and 13.",
    "Rows 0 and 2 change places: the first and the third 12 bits of the alphas; bytes 12 and 14.",
    "Rows 0 and 3 change places, and 1 and 2: the 12 bits of each in the alphas; bytes 12 and 15, 13 and 14."};

const char* bytesThatMove(BlockFormat format, int rows) {
    const auto& words = format == BlockFormat::Dxt5   ? bytesOfDxt5
                        : format == BlockFormat::Dxt3 ? bytesOfDxt3
                                                      : bytesOfDxt1;
    return words.at(static_cast<std::size_t>(rows - 2));
}

/// How far what was compressed again is from the mirrored picture, over all components.
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

std::vector<std::string> beginning(const BlockImage& image) {
    const int height = image.height;
    std::vector<std::string> words{
        "As the file has it: its first row is the upper one of the image, and OpenGL "
        "takes it for the lowest."};
    if (height == 1)
        words.emplace_back("There is one row: nothing is to be done.");
    else if (height < 4)
        words.push_back(fmt::format("One row of blocks, of which {} texel rows lie in the picture.", height));
    else if (!flipsWithoutLoss(height))
        words.push_back(
            fmt::format("A height of {} is no multiple of 4: the last block is used in part. Go on "
                        "to see what the usual steps make of it.",
                        height));
    return words;
}

std::vector<std::string> turning(std::span<const FlipStep> steps, std::size_t step) {
    const BlockImage& image = steps[step].after;
    const int rows = turnedRows(image.height);
    std::vector<std::string> words{fmt::format("Inside the blocks of row {}.", steps[step].first),
                                   bytesThatMove(image.format, rows)};
    if (rows < 4)
        words.emplace_back("The rows outside of the picture keep their bits.");
    const bool isLastTurn = step + 1 == steps.size() || steps[step + 1].act == Act::Recompress;
    if (!isLastTurn)
        return words;
    if (flipsWithoutLoss(image.height))
        words.emplace_back("Done: the picture is upside down, and no colour has changed.");
    else
        words.push_back(
            fmt::format("Wrong: the picture begins with {} unused rows, and as many of its own have "
                        "fallen out.",
                        4 - image.height % 4));
    return words;
}

} // namespace

std::span<const RowPair> rowPairs(int rows) {
    switch (rows) {
    case 2:
        return pairsOfTwo;
    case 3:
        return pairsOfThree;
    case 4:
        return pairsOfFour;
    default:
        return {};
    }
}

std::vector<std::string> flipSentences(std::span<const FlipStep> steps, std::size_t step) {
    const FlipStep& now = steps[step];
    switch (now.act) {
    case Act::AsStored:
        return beginning(now.after);
    case Act::SwapBlockRows: {
        std::vector<std::string> words{fmt::format(
            "The rows of blocks {} and {} change places, each block as it is.", now.first, now.second)};
        if (now.second - now.first == 2)
            words.emplace_back("The one in the middle stays where it is.");
        return words;
    }
    case Act::TurnRows:
        return turning(steps, step);
    case Act::Recompress:
        break;
    }
    return {
        "A new block would need rows of two old ones, and has two end colours for all of them.",
        fmt::format("Decompressed, turned around and compressed again it differs by {:.1f} of 255 (RMS).",
                    errorOf(steps.front().after, now.after)),
        "Texplorer decompresses such a texture when it loads it, and turns its pixels around; texshot flip "
        "refuses it without --lossy."};
}

} // namespace texplorer::ui

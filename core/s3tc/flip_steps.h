#pragma once

// The steps of flipVertically() of core/s3tc/flip.h, to show them.

#include "texplorer/base/result.h"
#include "texplorer/image/block_image.h"
#include "texplorer/s3tc/encode_quality.h"

#include <cstdint>
#include <vector>

namespace texplorer {

struct FlipStep {
    enum class Act : std::uint8_t {
        AsStored,      ///< the start
        SwapBlockRows, ///< the rows of blocks `first` and `second` are swapped; their bytes stay
        TurnRows,      ///< in every block of row `first`, the rows of texels are swapped
        Recompress,    ///< instead of all that: decompressed, flipped and compressed again
    };
    Act act = Act::AsStored;
    int first = 0;
    int second = 0;
    BlockImage after; ///< the image after the step
};

/// Returns the steps for a picture; the last one has the result of flipVertically(). For a height that it
/// refuses, the steps are those for the next multiple of 4, which show what is wrong with it, and then
/// decodeFlipEncode() of the original picture. Errors: Malformed if the size of `blocks` does not match the
/// extents, and those of decodeFlipEncode().
[[nodiscard]] Result<std::vector<FlipStep>> flipSteps(const BlockImage& image,
                                                      EncodeQuality quality = EncodeQuality::Best);

/// The number of texel rows of a block that are reversed in a picture of this height: 1 (none), 2, 3 or 4.
[[nodiscard]] constexpr int turnedRows(int height) {
    return height < 4 ? height : 4;
}

} // namespace texplorer

#pragma once

// flipVertically() of core/s3tc/flip.h, one step after the other: what a drawing of it shows.

#include "core/base/result.h"
#include "core/image/block_image.h"
#include "core/s3tc/encode_quality.h"

#include <cstdint>
#include <vector>

namespace texplorer {

struct FlipStep {
    enum class Act : std::uint8_t {
        AsStored,      ///< the beginning
        SwapBlockRows, ///< the rows of blocks `first` and `second` change places; their bytes stay as they
                       ///< are
        TurnRows,      ///< in every block of row `first`, the rows of texels change places
        Recompress,    ///< instead of all of that: decompressed, turned around and compressed again
    };
    Act act = Act::AsStored;
    int first = 0;
    int second = 0;
    BlockImage after; ///< what the image is then
};

/// The steps for one picture. The last one has what flipVertically() makes of it. Of a height that
/// flipVertically() refuses, the steps are those for the next multiple of 4, which shows what is wrong with
/// it, and then decodeFlipEncode() from the picture as it was. Errors: Malformed where `blocks` has not the
/// size that the extents ask for, and those of decodeFlipEncode().
[[nodiscard]] Result<std::vector<FlipStep>> flipSteps(const BlockImage& image,
                                                      EncodeQuality quality = EncodeQuality::Best);

/// How many texel rows of a block are turned around in a picture of this height: 1 (none), 2, 3 or 4.
[[nodiscard]] constexpr int turnedRows(int height) {
    return height < 4 ? height : 4;
}

} // namespace texplorer

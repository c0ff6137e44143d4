#pragma once

// Texel weights along one axis: which texels of a row are mixed, and how much of each. Uses the functions for
// whole textures (wrap.h); with several axes, the weights are products.

#include "texplorer/reference/sampling/wrap.h"

#include <vector>

namespace texplorer::reference {

/// A texel of a row and its weight.
struct RowTexel {
    int index = 0; ///< outside of [0, size): border
    float weight = 0;

    bool operator==(const RowTexel&) const = default;
};

/// What GL reads from a row of texels at a coordinate.
struct RowSample {
    float texels = 0; ///< s times size, before the wrap mode
    float u = 0;      ///< after the wrap mode
    /// Under LINEAR: the position of u from the centre of the first texel to that of the second, 0 to 1.
    float alpha = 0;
    std::vector<RowTexel> taps; ///< one under NEAREST, two under LINEAR, also with weight 0
    float border = 0;           ///< the border's share of the colour
};

/// For a row of `size` texels, at least 1, without a border image.
[[nodiscard]] RowSample sampleRow(Wrap wrap, bool linear, float s, int size);

/// A range of coordinates in which the same texels are read, with linear weights.
struct RowPiece {
    float from = 0;
    float to = 0;
    struct Share {
        int index = 0;
        float from = 0; ///< the weight at the beginning of the range
        float to = 0;   ///< and at its end

        bool operator==(const Share&) const = default;
    };
    std::vector<Share> shares; ///< without those of weight 0
};

/// Splits a range of coordinates into pieces of half a texel, in order: in each, wrap mode and filter read
/// the same texels. `from` and `to` are multiples of half a texel.
[[nodiscard]] std::vector<RowPiece> rowPieces(Wrap wrap, bool linear, float from, float to, int size);

} // namespace texplorer::reference

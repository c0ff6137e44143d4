#pragma once

// One row of texels, one coordinate: which of them are mixed, and how much of each. The same functions as
// those of whole textures (wrap.h); a texture of several axes has the products of such weights.

#include "core/reference/sampling/wrap.h"

#include <vector>

namespace texplorer::reference {

/// A texel of a row and its weight.
struct RowTexel {
    int index = 0; ///< outside of [0, size) it is border
    float weight = 0;

    bool operator==(const RowTexel&) const = default;
};

/// What GL reads of a row of texels at a coordinate.
struct RowSample {
    float texels = 0; ///< s times size, before the wrap mode
    float u = 0;      ///< after it
    float alpha = 0;  ///< under LINEAR: how far u is from the centre of the first texel to that of the second
    std::vector<RowTexel> taps; ///< one under NEAREST, two under LINEAR, whatever their weights
    float border = 0;           ///< the border's share in the colour
};

/// Of a row of `size` texels, 1 or more, without a border image of its own.
[[nodiscard]] RowSample sampleRow(Wrap wrap, bool linear, float s, int size);

/// A stretch of coordinates on which the same texels are read, with weights that change evenly.
struct RowPiece {
    float from = 0;
    float to = 0;
    struct Share {
        int index = 0;
        float from = 0; ///< its weight where the piece begins
        float to = 0;   ///< and where it ends

        bool operator==(const Share&) const = default;
    };
    std::vector<Share> shares; ///< without those that have none
};

/// The stretches from one coordinate to another, in order, each half a texel wide: no wrap mode and no filter
/// changes its mind within one. `from` and `to` are whole halves of texels.
[[nodiscard]] std::vector<RowPiece> rowPieces(Wrap wrap, bool linear, float from, float to, int size);

} // namespace texplorer::reference

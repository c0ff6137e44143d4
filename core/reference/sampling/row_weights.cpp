#include "texplorer/reference/sampling/row_weights.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace texplorer::reference {

RowSample sampleRow(Wrap wrap, bool linear, float s, int size) {
    assert(size > 0);
    RowSample sample;
    sample.texels = s * static_cast<float>(size);
    sample.u = wrapCoordinate(wrap, s, size);
    if (linear) {
        const TexelPair pair = linearTexels(wrap, sample.u, size);
        sample.alpha = pair.share;
        sample.taps = {{pair.first, 1 - pair.share}, {pair.second, pair.share}};
    } else {
        sample.taps = {{nearestTexel(sample.u, size), 1}};
    }
    for (const RowTexel& tap : sample.taps)
        sample.border += tap.index < 0 || tap.index >= size ? tap.weight : 0;
    return sample;
}

std::vector<RowPiece> rowPieces(Wrap wrap, bool linear, float from, float to, int size) {
    const float half = 0.5F / static_cast<float>(size);
    const auto count = static_cast<std::size_t>(std::max(0L, std::lround((to - from) / half)));
    std::vector<RowPiece> pieces(count);
    for (std::size_t i = 0; i < count; ++i) {
        RowPiece& piece = pieces[i];
        piece.from = from + half * static_cast<float>(i);
        piece.to = piece.from + half;
        // The ends belong to two pieces; what is between them tells which texels this one reads.
        const RowSample early = sampleRow(wrap, linear, piece.from + half / 4, size);
        const RowSample late = sampleRow(wrap, linear, piece.to - half / 4, size);
        for (std::size_t tap = 0; tap < early.taps.size(); ++tap) {
            const float low = early.taps[tap].weight;
            const float high = late.taps[tap].weight;
            const float more = (high - low) / 2; // from a quarter to the end, and from the start to a quarter
            const RowPiece::Share share{early.taps[tap].index, low - more, high + more};
            if (share.from > 0 || share.to > 0)
                piece.shares.push_back(share);
        }
    }
    return pieces;
}

} // namespace texplorer::reference

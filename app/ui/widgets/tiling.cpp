#include "app/ui/widgets/tiling.h"

#include <algorithm>

namespace texplorer::ui {

std::optional<TileSpan> tileSpan(Wrap wrap, int tile, int texels) {
    if (tile == 0 || wrap == Wrap::Repeat)
        return TileSpan{0, 1};
    switch (wrap) {
    case Wrap::MirroredRepeat:
        return tile % 2 == 0 ? TileSpan{0, 1} : TileSpan{1, 0};
    case Wrap::ClampToBorder:
        return std::nullopt;
    default: {
        const float half = 0.5F / static_cast<float>(std::max(1, texels));
        return tile < 0 ? TileSpan{half, half} : TileSpan{1 - half, 1 - half};
    }
    }
}

} // namespace texplorer::ui

#pragma once

#include "app/ui/figures/block_source.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "core/s3tc/block_parts.h"

#include <optional>
#include <string>

namespace texplorer::ui {

struct BlockMicroscopeState {
    BlockMicroscopeState();

    BlockFormat format;
    BlockBytes block;
    std::size_t texel = 0;               ///< the chosen one, which gets what is clicked in the palette
    std::optional<BlockMark> hovered{};  ///< what the pointer rested on in the frame before
    std::optional<BlockMark> hovering{}; ///< and in this one
    std::string hex{};                   ///< as it is typed
    std::string hexProblem{};            ///< a sentence without its full stop
    BlockSource source{};
};

void drawBlockMicroscope(Session& session, BlockMicroscopeState& state, const Pictures& pictures);

} // namespace texplorer::ui

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
    std::size_t texel = 0;               ///< the selected one; a click in the palette sets its colour
    std::optional<BlockMark> hovered{};  ///< under the pointer in the previous frame
    std::optional<BlockMark> hovering{}; ///< under the pointer in this frame
    std::string hex{};                   ///< the text being typed
    std::string hexProblem{};            ///< a sentence without its full stop
    BlockSource source{};
};

void drawBlockMicroscope(const Session& session, BlockMicroscopeState& state, const Pictures& pictures);

} // namespace texplorer::ui

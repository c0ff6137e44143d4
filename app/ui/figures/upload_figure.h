#pragma once

// How OpenGL reads an image in a program's memory: its bytes, and the texels that they become.

#include "app/ui/figures/held_levels.h"
#include "app/ui/figures/upload_bytes.h"
#include "app/ui/widgets/upload_edits.h"

#include <imgui.h>

#include <optional>

namespace texplorer::ui {

/// Under the pointer: a texel, or a byte of the memory.
struct UploadMark {
    std::optional<TexelPlace> texel{};
    std::optional<std::size_t> byte{};
};

struct UploadFigureState {
    HeldLevels held{};
    std::optional<LevelsRequest> asked{}; ///< of the bound texture: the source of `facts`
    UploadFacts facts{};
    UploadMark hovered{};                   ///< in the previous frame
    UploadMark hovering{};                  ///< in this frame
    std::optional<std::size_t> scrollsTo{}; ///< the byte to bring into view
};

void drawUploadFigure(const Session& session, UploadFigureState& state);

/// What both parts of the figure show.
struct UploadLook {
    UploadBytes bytes;
    const Bytes* memory = nullptr; ///< followed by zeros, if the call reads beyond its end
    const Image* read = nullptr;
    bool topFirst = false; ///< whether row 0 is the top one
};

/// The memory, a line for each row that the program holds.
void drawUploadMemory(UploadFigureState& state, const UploadLook& look, ImVec2 size);

/// The first texels.
void drawUploadTexels(UploadFigureState& state, const UploadLook& look, ImVec2 size);

} // namespace texplorer::ui

#pragma once

// Draws texels and the colours of a block.

#include "texplorer/s3tc/block_parts.h"

#include <imgui.h>

namespace texplorer::ui {

/// A colour, with a board behind it if it is transparent.
void drawSwatch(ImVec2 low, ImVec2 high, const BlockColor& color);

/// The width of a letter of code.
[[nodiscard]] float codeLetter();

/// The frame around a swatch, if there is one: a chosen one's has another colour than a lit one's.
void drawSwatchFrame(ImVec2 low, ImVec2 high, bool chosen, bool lit);

/// Centred text on a colour, readable on any; smaller if the swatch is low.
void drawOnSwatch(ImVec2 low, ImVec2 high, const char* words);

/// An invisible button of this size, for keyboard and pointer.
struct Spot {
    ImVec2 low;
    ImVec2 high;
    bool pressed = false;
    bool hovered = false;
};

[[nodiscard]] Spot spotHere(const char* id, ImVec2 size);

} // namespace texplorer::ui

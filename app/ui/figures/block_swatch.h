#pragma once

// How texels and the colours of a block are drawn.

#include "core/s3tc/block_parts.h"

#include <imgui.h>

namespace texplorer::ui {

/// A colour with what is behind it where it is transparent.
void drawSwatch(ImDrawList& draw, ImVec2 low, ImVec2 high, const BlockColor& color);

/// What is drawn around something.
enum class SwatchFrame { None, Lit, Chosen };

void drawSwatchFrame(ImDrawList& draw, ImVec2 low, ImVec2 high, SwatchFrame frame);

/// Words on a colour, readable on any, in the middle; smaller where it is low.
void drawOnSwatch(ImDrawList& draw, ImVec2 low, ImVec2 high, const char* words);

/// An invisible button of this size; keyboard and pointer rest on it alike.
struct Spot {
    ImVec2 low;
    ImVec2 high;
    bool pressed = false;
    bool hovered = false;
};

[[nodiscard]] Spot spotHere(const char* id, ImVec2 size);

} // namespace texplorer::ui

#pragma once

#include <span>

namespace texplorer::ui {

/// Keys that count while the pointer is over the texture space, and what they do: for lists of keys.
struct PlaneKeyRow {
    const char* keys;
    const char* effect;
};

[[nodiscard]] std::span<const PlaneKeyRow> planeKeys();

} // namespace texplorer::ui

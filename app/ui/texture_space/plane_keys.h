#pragma once

#include <span>

namespace texplorer::ui {

/// The keys of the texture space, active while the pointer is over it, and their effects: for lists of keys.
struct PlaneKeyRow {
    const char* keys;
    const char* effect;
};

[[nodiscard]] std::span<const PlaneKeyRow> planeKeys();

} // namespace texplorer::ui

#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// Calls `item`, which draws an item that later ones may cover and take clicks from; returns its result. Dear
/// ImGui must be told before the item since 1.89.7, and after it in earlier versions.
template<typename Item>
bool overlappedItem(Item item) {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
    return item();
#else
    const bool result = item();
    ImGui::SetItemAllowOverlap();
    return result;
#endif
}

} // namespace texplorer::ui

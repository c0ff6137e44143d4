#include "app/ui/figures/shrunk_text.h"

#include "app/ui/widgets/fitted_text.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace texplorer::ui {

void shrunkText(ImVec2 at, const std::string& words, float size, float room, ImU32 ink) {
    constexpr float minScale = 0.75F;
    const float width = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, words.c_str()).x;
    const float fitting = width > room ? std::max(size * minScale, size * room / width) : size;
    // The cut is measured with the window's letters.
    const std::string shown =
        width * fitting / size > room + 0.5F ? fitted(words, room * ImGui::GetFontSize() / fitting) : words;
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), fitting,
                                        {std::round(at.x), std::round(at.y + (size - fitting) / 2)}, ink,
                                        shown.c_str());
}

} // namespace texplorer::ui

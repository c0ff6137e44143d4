#include "app/ui/language/translate.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/widgets/widget_places.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace texplorer::ui {

namespace {

constexpr int around = 5; // pixels on each side of the one under the mouse
constexpr int across = 2 * around + 1;

/// One picture under the glass.
struct Lens {
    std::string name;
    view::PictureHandle picture = view::PictureHandle::None;
    std::string value; ///< of the pixel in the middle
    ImU32 swatch = 0;  ///< its colour; 0: not known
};

ImU32 colorOf(const Image& image, glm::ivec2 pixel) {
    const ByteView bytes = image.at(pixel.x, pixel.y);
    return IM_COL32(std::to_integer<int>(bytes[0]), std::to_integer<int>(bytes[1]),
                    std::to_integer<int>(bytes[2]), 255);
}

/// "28 33 41 · 255": red, green, blue, and the framebuffer's alpha.
std::string textOf(const Image& image, glm::ivec2 pixel) {
    const ByteView bytes = image.at(pixel.x, pixel.y);
    const auto number = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
    return fmt::format("{} {} {} · {}", number(0), number(1), number(2), number(3));
}

/// The picture of a renderer; nullptr: it is not known, or has no such pixel.
const Image* imageWith(const Pictures& pictures, RendererKind renderer, glm::ivec2 pixel) {
    const auto view = std::ranges::find(pictures.frames, renderer, &ViewFrame::renderer);
    const Image* image = view == pictures.frames.end() ? nullptr : view->image.get();
    return image && pixel.x < image->width && pixel.y < image->height ? image : nullptr;
}

/// The difference of the two compared pictures at that pixel, for each component.
std::string differenceText(const ViewSettings& settings, const Pictures& pictures, glm::ivec2 pixel) {
    const Image* first = imageWith(pictures, settings.compared[0], pixel);
    const Image* second = imageWith(pictures, settings.compared[1], pixel);
    if (!first || !second)
        return "…";
    const ByteView a = first->at(pixel.x, pixel.y);
    const ByteView b = second->at(pixel.x, pixel.y);
    std::string text;
    for (std::size_t c = 0; c < 3; ++c) {
        const int difference = std::to_integer<int>(b[c]) - std::to_integer<int>(a[c]);
        text += fmt::format("{}{}{}", c > 0 ? " " : "", difference > 0 ? "+" : "", difference);
    }
    return text;
}

std::vector<Lens> lensesOf(const Session& session, const Panes& panes, const Pictures& pictures,
                           glm::ivec2 pixel) {
    std::vector<Lens> lenses;
    for (const Pane& pane : panes.all()) {
        const view::PictureHandle picture = pictureOf(pane, pictures);
        if (!pane.renderer) {
            lenses.push_back({N_("Difference"), picture, differenceText(session.view, pictures, pixel)});
            continue;
        }
        const Image* image = imageWith(pictures, *pane.renderer, pixel);
        lenses.push_back({std::string(rowOf(*pane.renderer).label), picture,
                          image ? textOf(*image, pixel) : "…", image ? colorOf(*image, pixel) : 0});
    }
    return lenses;
}

/// The pixels around one, each as a square of `cell`; outside of the picture it stays dark.
void drawPixels(ImDrawList& draw, ImVec2 low, float cell, view::PictureHandle handle, glm::ivec2 pixel,
                view::Size picture, ImDrawCallback setBlending) {
    const float extent = cell * across;
    draw.AddRectFilled(low, {low.x + extent, low.y + extent}, color::ground);
    const glm::ivec2 first = glm::max(pixel - around, glm::ivec2(0));
    const glm::ivec2 end = glm::min(pixel + around + 1, glm::ivec2(picture.width, picture.height));
    if (handle != view::PictureHandle::None && first.x < end.x && first.y < end.y) {
        const auto place = [&](int x, int y) { // the lower left corner of a pixel
            return ImVec2(low.x + static_cast<float>(x - pixel.x + around) * cell,
                          low.y + static_cast<float>(pixel.y + around + 1 - y) * cell);
        };
        const auto share = [&](int x, int y) {
            return ImVec2(static_cast<float>(x) / static_cast<float>(picture.width),
                          static_cast<float>(y) / static_cast<float>(picture.height));
        };
        if (setBlending)
            draw.AddCallback(setBlending, nullptr);
        draw.AddImage(textureId(handle), place(first.x, end.y), place(end.x, first.y), share(first.x, end.y),
                      share(end.x, first.y));
        if (setBlending)
            draw.AddCallback(setBlending, &draw);
    }
    const ImVec2 middle(low.x + cell * around, low.y + cell * around);
    draw.AddRect({middle.x - 1, middle.y - 1}, {middle.x + cell + 1, middle.y + cell + 1}, color::shade);
    draw.AddRect(middle, {middle.x + cell, middle.y + cell}, color::text);
}

} // namespace

void drawMagnifier(const Session& session, const Panes& panes, const Pictures& pictures,
                   const Layout& layout) {
    if (!session.view.magnifies)
        return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::optional<glm::ivec2> pixel = panes.pixelAt(mouse);
    if (!pixel)
        return;
    const view::Size picture = pictures.frames.front().frame.size;
    const std::vector<Lens> lenses = lensesOf(session, panes, pictures, *pixel);
    const float em = ImGui::GetFontSize();
    const float pad = em * 0.5F;
    const float cell = std::max(2.0F, std::round(em * 0.7F));
    float widest = std::max(cell * across, ImGui::CalcTextSize("255 255 255 · 255").x + em * 1.1F);
    for (const Lens& lens : lenses)
        widest = std::max(widest, ImGui::CalcTextSize(tr(lens.name).c_str()).x);
    const ImVec2 size(widest, cell * across + 2.6F * em);
    const std::string where = tr(Sentence("Pixel {0},{1} from the upper left", pixel->x,
                                          picture.height - 1 - pixel->y)); // counted like texshot probe --at
    const Rect& window = layout.window;
    const int maxColumns =
        std::max(1, static_cast<int>((static_cast<float>(window.width) - pad) / (size.x + pad)));
    const int columns = std::min(maxColumns, static_cast<int>(lenses.size()));
    const int rows = (static_cast<int>(lenses.size()) + columns - 1) / columns;
    const ImVec2 whole(std::max(static_cast<float>(columns) * (size.x + pad) + pad,
                                ImGui::CalcTextSize(where.c_str()).x + 2 * pad),
                       static_cast<float>(rows) * (size.y + pad) + pad + em * 1.2F);
    // Next to the mouse, and inside of the window.
    const float away = em * 1.4F;
    ImVec2 low(mouse.x + away, mouse.y + away);
    if (low.x + whole.x > static_cast<float>(window.right()))
        low.x = mouse.x - away - whole.x;
    if (low.y + whole.y > static_cast<float>(window.bottom()))
        low.y = mouse.y - away - whole.y;
    low.x = std::round(std::max(low.x, static_cast<float>(window.x)));
    low.y = std::round(std::max(low.y, static_cast<float>(window.y)));

    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    draw.AddRectFilled(low, {low.x + whole.x, low.y + whole.y}, ImGui::GetColorU32(ImGuiCol_PopupBg), pad);
    draw.AddRect(low, {low.x + whole.x, low.y + whole.y}, ImGui::GetColorU32(ImGuiCol_Border), pad);
    noteDrawn("magnifier", low, {low.x + whole.x, low.y + whole.y});
    draw.AddText({low.x + pad, low.y + pad * 0.7F}, color::dim, where.c_str());
    noteDrawn("magnifier:where", {low.x + pad, low.y},
              {low.x + pad + ImGui::CalcTextSize(where.c_str()).x, low.y + em * 1.2F});
    for (std::size_t i = 0; i < lenses.size(); ++i) {
        const Lens& lens = lenses[i];
        const std::div_t place = std::div(static_cast<int>(i), columns);
        const auto column = static_cast<float>(place.rem);
        const auto row = static_cast<float>(place.quot);
        const ImVec2 at(low.x + pad + column * (size.x + pad),
                        low.y + pad + em * 1.2F + row * (size.y + pad));
        drawPixels(draw, at, cell, lens.picture, *pixel, picture, pictures.setBlending);
        const float text = at.y + cell * across + em * 0.3F;
        draw.AddText({at.x, text}, color::dim, tr(lens.name).c_str());
        float x = at.x;
        if (lens.swatch != 0) {
            draw.AddRectFilled({x, text + em * 1.3F}, {x + em * 0.8F, text + em * 2.1F}, lens.swatch, 2);
            draw.AddRect({x, text + em * 1.3F}, {x + em * 0.8F, text + em * 2.1F}, color::outline, 2);
            x += em * 1.1F;
        }
        draw.AddText({x, text + em * 1.15F}, color::text, lens.value.c_str());
        const ImVec2 middle(at.x + cell * (around + 0.5F), at.y + cell * (around + 0.5F));
        noteDrawn("lens:" + lens.name, middle, middle);
    }
}

} // namespace texplorer::ui

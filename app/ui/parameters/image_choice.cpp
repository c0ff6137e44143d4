#include "app/ui/files/asking.h"
#include "app/ui/model/preview.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr std::size_t minPerLine = 8;

/// One picture of the choice, and the edits that set it.
struct Choice {
    std::string name; ///< its name in tests
    Sentence label;
    std::string_view help;
    std::shared_ptr<const Image> image;
    bool isCurrent;
    std::string path;
    std::vector<Edit> edits;
};

void drawChoice(const Session& session, const Pictures& pictures, const Choice& choice, float extent) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + extent, low.y + extent);
    ImGui::PushID(choice.name.c_str());
    const bool pressed = ImGui::InvisibleButton("image", {extent, extent});
    noteItem(choice.name);
    const bool hovered = ImGui::IsItemHovered();
    helpTip(Sentence("{0}\n{1}", choice.label, choice.help));
    ImGui::PopID();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, color::ground);
    if (choice.image && !choice.image->empty())
        drawImage(pictures, choice.image, low, high);
    const float line = std::max(1.0F, std::floor(ImGui::GetFontSize() / 8));
    if (choice.isCurrent || hovered)
        draw.AddRect({low.x - line, low.y - line}, {high.x + line, high.y + line},
                     ImGui::GetColorU32(choice.isCurrent ? ImGuiCol_CheckMark : ImGuiCol_Text), 0, 0,
                     choice.isCurrent ? 1.5F * line : line);
    if (hovered && !choice.isCurrent)
        preview(session, choice.name, choice.label,
                [&](Scene& scene) { static_cast<void>(makeEdits(scene, choice.edits)); });
    if (pressed && !choice.isCurrent)
        submit(session, {.name = choice.label, .edits = choice.edits, .path = choice.path});
}

Edit sourceIs(const std::string& texture, SourceKind source) {
    return edit::Set{fmt::format("{}.{}", texture, keyOf<&Texture::source>()),
                     std::string(rowOf(source).name)};
}

/// An available file, whether it is shown at present or not.
std::optional<Choice> fileChoice(const Session& session, const std::string& path) {
    Texture texture = *boundTexture(session);
    if (texture.file.empty() || !session.document.images.holds(texture.file))
        return std::nullopt;
    const bool isCurrent = texture.source == SourceKind::File;
    texture.source = SourceKind::File;
    return Choice{path + "." + keyOf<&Texture::file>() + "=shown",
                  nameOfImage(texture),
                  N_("The image file of this texture"),
                  thumbnailOf(session, texture, selectedUnit(session).target),
                  isCurrent,
                  path + "." + keyOf<&Texture::file>(),
                  {sourceIs(path, SourceKind::File)}};
}

} // namespace

void imageChoice(const Session& session, const Pictures& pictures) {
    const Texture& texture = *boundTexture(session);
    const std::string path =
        elementOf<&Scene::textures>(static_cast<std::size_t>(selectedUnit(session).texture));
    labelText(N_("Image"));
    ImGui::SameLine();
    const float right = ImGui::GetContentRegionMax().x;
    const bool isWide = ImGui::GetCursorPosX() + buttonWidth(N_("Open image…")) <= right;
    const char* open = isWide ? N_("Open image…") : N_("Open…");
    if (ImGui::GetCursorPosX() + buttonWidth(open) > right)
        ImGui::NewLine();
    const float room = right - buttonWidth(open) - ImGui::GetStyle().ItemSpacing.x - ImGui::GetCursorPosX();
    const bool hasRoom = room > ImGui::GetFontSize() * 3; // for more than dots
    dimPlainText(hasRoom ? fitted(nameOfImage(texture), room) : "");
    helpTip(nameOfImage(texture));
    ImGui::SameLine(std::max(0.0F, right - buttonWidth(open)));
    if (button(open, N_("open image"),
               "Opens an image file for this texture. Or drop one onto the window (Ctrl+I)"))
        act(session, [](Session& s) { askOpenImage(s); });

    ask(session, [](Session& s) { return workers(s).patterns->ask(); });
    std::vector<Choice> choices;
    for (const EnumRow& row : patternRows) {
        const auto pattern = static_cast<Pattern>(row.value);
        const std::string rowPath = path + "." + keyOf<&Texture::pattern>();
        choices.push_back({fmt::format("{}={}", rowPath, row.name),
                           row.label,
                           row.help,
                           workers(session).patterns->find(pattern),
                           texture.source == SourceKind::Pattern && texture.pattern == pattern,
                           rowPath,
                           {sourceIs(path, SourceKind::Pattern), edit::Set{rowPath, std::string(row.name)}}});
    }
    if (std::optional<Choice> file = fileChoice(session, path))
        choices.push_back(std::move(*file));
    const float em = ImGui::GetFontSize();
    const float gap = std::floor(em * 0.27F);
    const float least = std::max(em * 2, targetHeight());
    const auto count = static_cast<std::size_t>(
        std::clamp((ImGui::GetContentRegionAvail().x + gap) / (least + gap), 1.0F, 16.0F));
    const std::size_t perLine = targetHeight() > 0 ? count : std::max(count, minPerLine);
    const float extent =
        std::floor((ImGui::GetContentRegionAvail().x + gap) / static_cast<float>(perLine) - gap);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i % perLine > 0)
            ImGui::SameLine();
        drawChoice(session, pictures, choices[i], std::max(1.0F, extent));
    }
    ImGui::PopStyleVar();
}

} // namespace texplorer::ui

// The tab "File": the structure of a texture's file, as a table of fields and as bytes.

#include "app/ui/details/file_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/levels/memory_tab.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence.h"
#include "texplorer/text/printable.h"
#include "texplorer/texture/level_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

int offsetDigits(std::size_t fileBytes) {
    return fileBytes > 0xFFFFFF ? 8 : fileBytes > 0xFFFF ? 6 : 4;
}

void fieldTip(const Field& field) {
    std::vector<TipLine> lines;
    const auto add = [&lines](const Sentence& words) {
        lines.push_back({printable(tr(words), LineBreaks::Keep)});
    };
    add(field.value.empty() ? field.name : Sentence("{0} = {1}", field.name, field.value));
    if (!field.meaning.empty())
        add(field.meaning);
    if (!field.wrong.empty())
        add(field.wrong);
    add(Sentence("{0} from offset {1}", Sentence::plural("{0} byte", "{0} bytes", field.size), field.offset));
    showTip(lines);
}

Sentence indented(const Field& field) {
    const std::string space(static_cast<std::size_t>(std::clamp(field.depth, 0, 8)) * 2, ' ');
    return Sentence("{0}{1}", ProperName{space}, field.name);
}

void fieldRow(FileTabState& state, std::size_t index, int digits, std::optional<std::size_t>& hovered) {
    const Field& field = state.content->anatomy.fields[index];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(index));
    const bool lit = state.hovered == index;
    if (ImGui::Selectable("##row", lit,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap))
        state.revealInBytes = index;
    noteItem("field:" + field.name.english());
    if (ImGui::IsItemHovered()) {
        hovered = index;
        fieldTip(field);
    }
    ImGui::PopID();
    ImGui::SameLine(0, 0);
    ImGui::PushFont(codeFont());
    ImGui::TextDisabled("%s", fmt::format("{:0{}X}", field.offset, digits).c_str());
    ImGui::PopFont();
    const bool fine = field.wrong.empty();
    const ImU32 ink = fine ? color::text : color::problem;
    ImGui::TableNextColumn();
    fittedText(indented(field), ink);
    ImGui::TableNextColumn();
    if (!field.value.empty()) {
        fittedText(field.value, ink);
        ImGui::SameLine(0, ImGui::GetFontSize() * 0.7F);
    }
    if (ImGui::GetContentRegionAvail().x > ImGui::GetFontSize() * 2)
        fittedText(fine ? field.meaning : field.wrong, fine ? color::dim : color::problem);
}

/// Wide enough for the first names, but at most about a third of the panel.
float nameWidth(const std::vector<Field>& fields) {
    float width = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(fields.size(), 64); ++i)
        width = std::max(width, textWidth(indented(fields[i])));
    return std::min(width, ImGui::GetContentRegionAvail().x * 0.38F);
}

void fieldTable(FileTabState& state, float height, std::optional<std::size_t>& hovered) {
    const std::vector<Field>& fields = state.content->anatomy.fields;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_Resizable |
                                      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings |
                                      ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("fields", 3, flags, {0, height}))
        return;
    const int digits = offsetDigits(state.content->fileBytes);
    ImGui::PushFont(codeFont());
    const float offsets = ImGui::CalcTextSize("0").x * static_cast<float>(std::max(digits, 6));
    ImGui::PopFont();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn(label("Offset"), ImGuiTableColumnFlags_WidthFixed, offsets);
    ImGui::TableSetupColumn(label("Field"), ImGuiTableColumnFlags_WidthFixed, nameWidth(fields));
    ImGui::TableSetupColumn(label("Value and meaning"), ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    if (state.revealInTable) {
        const float row = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
        ImGui::SetScrollY(std::max(0.0F, row * static_cast<float>(*state.revealInTable) - height / 3));
        state.revealInTable.reset();
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(fields.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            fieldRow(state, static_cast<std::size_t>(i), digits, hovered);
    }
    ImGui::EndTable();
}

/// One line of bytes: offset, hexadecimal, characters.
struct HexLine {
    float letter; ///< width of a character
    int digits;   ///< of the offset
    std::size_t perLine;

    [[nodiscard]] float hexAt(std::size_t column) const {
        return letter * static_cast<float>(static_cast<std::size_t>(digits) + 2 + column * 3);
    }
    [[nodiscard]] float textAt(std::size_t column) const {
        return letter * static_cast<float>(static_cast<std::size_t>(digits) + 3 + perLine * 3 + column);
    }
    /// The byte at a position in the line, counted from the line's left edge.
    [[nodiscard]] std::optional<std::size_t> columnAt(float x) const {
        const float hex = (x - hexAt(0)) / (letter * 3);
        if (hex >= 0 && hex < static_cast<float>(perLine))
            return static_cast<std::size_t>(hex);
        const float text = (x - textAt(0)) / letter;
        if (text >= 0 && text < static_cast<float>(perLine))
            return static_cast<std::size_t>(text);
        return std::nullopt;
    }
};

void hexRow(FileTabState& state, const FieldMap& map, const HexLine& line, std::size_t row,
            std::optional<std::size_t>& hovered) {
    const DissectedFile& file = *state.content;
    const std::size_t first = row * line.perLine;
    const std::size_t count = std::min(line.perLine, file.bytes.size() - first);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    ImGui::Dummy({line.textAt(line.perLine), height});
    noteItem(fmt::format("hex:{}", first));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) {
        const auto column = line.columnAt(ImGui::GetIO().MousePos.x - corner.x);
        if (const auto field = column && *column < count ? map.at(first + *column) : std::nullopt) {
            hovered = field;
            fieldTip(file.anatomy.fields[*field]);
            if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
                state.revealInTable = field;
        }
    }
    draw.AddText(corner, color::dim, fmt::format("{:0{}X}", first, line.digits).c_str());
    for (std::size_t i = 0; i < count; ++i) {
        const int value = std::to_integer<int>(file.bytes[first + i]);
        const auto field = map.at(first + i);
        const bool wrong = field && !file.anatomy.fields[*field].wrong.empty();
        const ImU32 ink = wrong ? color::problem : field ? color::text : color::dim;
        const ImVec2 hex(corner.x + line.hexAt(i), corner.y);
        const ImVec2 text(corner.x + line.textAt(i), corner.y);
        if (field && field == state.hovered) {
            const bool goesOn = i + 1 < count && map.at(first + i + 1) == field;
            draw.AddRectFilled({hex.x - 1, hex.y},
                               {hex.x + line.letter * (goesOn ? 3.0F : 2.0F) + 1, hex.y + height},
                               color::lit);
            draw.AddRectFilled(text, {text.x + line.letter, text.y + height}, color::lit);
        }
        draw.AddText(hex, ink, fmt::format("{:02X}", value).c_str());
        const bool printable = value >= 0x20 && value < 0x7F;
        const std::array<char, 2> letter{printable ? static_cast<char>(value) : '.', '\0'};
        draw.AddText(text, printable ? ink : color::dim, letter.data());
    }
}

void hexView(FileTabState& state, const FieldMap& map, std::optional<std::size_t>& hovered) {
    const DissectedFile& file = *state.content;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, color::ground);
    ImGui::BeginChild("bytes", {0, 0}, false);
    ImGui::PushFont(codeFont());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    HexLine line{ImGui::CalcTextSize("0").x, offsetDigits(file.fileBytes), 4};
    // As many as fit, rounded down to a power of two.
    while (line.perLine < 32) {
        HexLine wider = line;
        wider.perLine *= 2;
        if (wider.textAt(wider.perLine) > ImGui::GetContentRegionAvail().x)
            break;
        line = wider;
    }
    const std::size_t rows = (file.bytes.size() + line.perLine - 1) / line.perLine;
    if (state.revealInBytes) {
        const Field& field = file.anatomy.fields[*state.revealInBytes];
        const std::uint64_t row = field.offset / line.perLine;
        ImGui::SetScrollY(std::max(0.0F, (static_cast<float>(row) - 1) * ImGui::GetTextLineHeight()));
        state.revealInBytes.reset();
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows), ImGui::GetTextLineHeight());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            hexRow(state, map, line, static_cast<std::size_t>(i), hovered);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    if (file.bytes.size() < file.fileBytes)
        dimText(Sentence("The first {0} of {1} bytes are shown.", ProperName{grouped(file.bytes.size())},
                         ProperName{grouped(file.fileBytes)}));
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

/// One line with the file's name and its problem.
void heading(const Session& session) {
    const InspectedFile& view = session.look.fileView;
    if (!view.chosen.empty()) {
        if (smallButton("←"))
            act(session, [](Session& changed) { changed.look.fileView.chosen.clear(); });
        item("file:back", "Back to the file of the bound texture");
        ImGui::SameLine();
    }
    const std::string path = view.shown.string();
    const std::string name = printable(view.shown.filename().string());
    if (view.content) {
        const std::string_view format = view.content->anatomy.format;
        text(Sentence("{0} · {1} · {2}", ProperName{name}, format.empty() ? N_("unknown format") : format,
                      bytesText(view.content->fileBytes)));
    } else
        text(ProperName{name});
    item("file:name", ProperName{path});
    if (!view.content)
        return;
    const Sentence& damage = view.content->anatomy.damage;
    const Sentence& problem = view.content->problem.empty() ? damage : view.content->problem;
    if (problem.empty())
        return;
    wrappedText(ProperName{printable(tr(problem))}, color::problem);
    noteItem("file:problem");
    if (!damage.empty() && damage != problem)
        helpTip(damage);
}

/// The format that is asked for when the file's image is uploaded, and the one that the driver took.
void drawStored(const Session& session, const view::StoredLevel& base) {
    const Texture& texture = *boundTexture(session);
    const std::optional<BlockFormat> blocks =
        planLevels(texture, session.document.images.picturesOf(texture), selectedUnit(session).target).blocks;
    const std::string_view asked = blocks ? rowOf(*blocks).name : rowOf(texture.internalFormat).name;
    fittedText(Sentence("{0} is asked for; the driver stores {1}", ProperName{asked}, storedLevelText(base)),
               color::dim);
    item("file:stored", N_("glGetTexLevelParameteriv of the largest level. The tab Memory has all levels."));
}

} // namespace

void drawFileTab(const Session& session, FileTabState& state, const Pictures& pictures) {
    const InspectedFile& view = session.look.fileView;
    const Texture* texture = boundTexture(session);
    if (view.shown.empty()) {
        wrappedText(!texture ? N_("No texture is bound to this unit.")
                    : isDrawn(texture->source)
                        ? N_("This texture is drawn in every frame. Open an image with "
                             "Ctrl+I to see the contents of its file.")
                        : N_("This texture is a built-in pattern without a file. Open an "
                             "image with Ctrl+I to see the contents of its file."));
        noteItem("file:none");
        return;
    }
    heading(session);
    if (const view::StoredTexture* stored = view.chosen.empty() ? storedOf(session, pictures) : nullptr)
        drawStored(session, stored->levels.front());
    if (!view.problem.empty())
        wrappedText(ProperName{printable(tr(view.problem))}, color::problem);
    if (!view.content) {
        if (view.ticket != 0)
            dimText("Reading…");
        return;
    }
    if (state.content != view.content) { // the fields belong to another file
        state = {};
        state.content = view.content;
    }
    std::optional<std::size_t> hovered;
    if (view.content->anatomy.fields.empty())
        dimText("Its fields are not known.");
    else
        fieldTable(state, ImGui::GetContentRegionAvail().y * 0.55F, hovered);
    hexView(state, view.map, hovered);
    state.hovered = hovered;
}

} // namespace texplorer::ui

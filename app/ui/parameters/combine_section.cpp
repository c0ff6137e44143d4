// GL_COMBINE of the selected unit: for colour and alpha a function, its equation, and one line per argument.

#include "app/ui/language/translate.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "texplorer/gl/combine_equation.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

/// The keys of one half of the table; those of arguments have a number in the middle.
struct Half {
    std::string_view title;
    std::string_view function;
    std::string_view scale;
    std::string_view suffix; ///< "source0" + suffix
};

constexpr std::array halves{Half{N_("Colour"), "rgb", "rgbScale", N_("Rgb")},
                            Half{N_("Alpha"), "alpha", "alphaScale", N_("Alpha")}};

const ParamRow& rowNamed(std::string_view key) {
    return *findParam(combineTable(), key); // the test draws every row
}

bool isPrevious(const EnumRow& choice) {
    return choice.value == static_cast<std::uint32_t>(CombineSource::Previous);
}

/// In lower case, for the middle of a sentence in English.
std::string sourceInWords(const Combine& combine, const std::string& key, bool isFirstUnit) {
    const ParamRow& row = rowNamed(key);
    const EnumRow* choice = findRow(row.choices, std::get<EnumValue>(row.read(&combine)).number);
    std::string words(choice ? choice->label : "?");
    if (choice && isFirstUnit && isPrevious(*choice))
        words = N_("Primary colour (no unit before)"); // OpenGL 2.1, section 3.8.13
    if (!catalogueInUse() && words.front() >= 'A' && words.front() <= 'Z')
        words.front() = static_cast<char>(words.front() - 'A' + 'a');
    return words;
}

/// "colour of this texture", "(1 - alpha of previous unit)"
std::string argumentInWords(const Combine& combine, const Half& half, int number, bool isFirstUnit) {
    const std::string tail = fmt::format("{}{}", number, half.suffix);
    const std::string source = sourceInWords(combine, "source" + tail, isFirstUnit);
    const auto operand = std::get<EnumValue>(rowNamed("operand" + tail).read(&combine)).number;
    switch (static_cast<OperandRgb>(operand)) { // same numbers as the operands of alpha
    case OperandRgb::SrcColor:
        return tr(Sentence("colour of {0}", source));
    case OperandRgb::OneMinusSrcColor:
        return tr(Sentence("(1 - colour of {0})", source));
    case OperandRgb::SrcAlpha:
        return tr(Sentence("alpha of {0}", source));
    case OperandRgb::OneMinusSrcAlpha:
        return tr(Sentence("(1 - alpha of {0})", source));
    }
    return "?";
}

/// The equation with the meaning of its arguments.
std::string inWords(const Combine& combine, const Half& half, std::string_view equation, bool isFirstUnit) {
    std::string words(equation);
    for (int number = 0; number < 3; ++number) {
        const std::string name = fmt::format("Arg{}", number);
        const std::string meaning = argumentInWords(combine, half, number, isFirstUnit);
        for (std::size_t at = words.find(name); at != std::string::npos;
             at = words.find(name, at + meaning.size()))
            words.replace(at, name.size(), meaning);
    }
    return words;
}

void drawEquation(const Session& session, const Combine& combine, const Half& half) {
    const bool isAlpha = half.suffix == "Alpha";
    if (isAlpha && combine.rgb == CombineRgb::Dot3Rgba) {
        wrappedText(Sentence("= the dot product of the colours: {0} overrides the rows below except the "
                             "scale.",
                             rowOf(combine.rgb).name));
        return;
    }
    std::string symbols(isAlpha ? equationOf(combine.alpha) : equationOf(combine.rgb));
    const std::string meaning = inWords(combine, half, symbols, session.look.selection.unit == 0);
    const int factor = static_cast<int>(isAlpha ? combine.alphaScale : combine.rgbScale);
    if (factor != 1)
        symbols = fmt::format("{} × ({})", factor, symbols);
    ImGui::TextUnformatted(("= " + symbols).c_str());
    noteItem("combine:equation" + std::string(half.suffix));
    plainWrappedText(meaning, color::dim);
    noteItem("combine:" + meaning);
}

/// The width of a list for its longest choice.
float widestChoice(const ParamRow& row) {
    float widest = 0;
    for (const EnumRow& choice : row.choices)
        widest = std::max(widest, textWidth(choice.label));
    return widest + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
}

void drawHalf(const Session& session, const Owner& owner, const Half& half) {
    const auto& combine = *static_cast<const Combine*>(owner.values);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float full = ImGui::GetContentRegionAvail().x;
    const float name = std::max(textWidth(N_("Colour")), textWidth(N_("Alpha"))) + 2 * gap;
    const float left = ImGui::GetCursorPosX();
    const float scale = ImGui::GetFontSize() * 3;
    const float times = ImGui::CalcTextSize("×").x;

    labelText(half.title);
    ImGui::SameLine(left + name);
    paramControl(session, owner, rowNamed(half.function), full - name - scale - times - 2 * gap);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted("×");
    ImGui::SameLine(0, gap);
    paramControl(session, owner, rowNamed(half.scale), scale);
    drawEquation(session, combine, half);

    // The operands are short: the sources get the rest, because their names must fit into a narrow panel.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ImGui::GetFontSize() * 0.25F, ImGui::GetStyle().FramePadding.y});
    const float argument = ImGui::CalcTextSize(N_("Arg0")).x + gap;
    float operand = 0; // the same in both halves
    for (const Half& each : halves)
        operand = std::max(operand, widestChoice(rowNamed("operand0" + std::string(each.suffix))));
    const float choices = full - argument - gap;
    for (int number = 0; number < 3; ++number) {
        const std::string tail = fmt::format("{}{}", number, half.suffix);
        const ParamRow& source = rowNamed("source" + tail);
        const bool inert = idleReasonOf(session.document.findings, owner.pathOf(source)) != nullptr;
        ImGui::AlignTextToFramePadding();
        plainText(fmt::format("Arg{}", number), inert ? color::dim : color::text);
        ImGui::SameLine(left + argument);
        paramControl(session, owner, source, std::max(choices / 2, choices - operand));
        ImGui::SameLine(0, gap);
        paramControl(session, owner, rowNamed("operand" + tail), std::min(choices / 2, operand));
    }
    ImGui::PopStyleVar();
}

} // namespace

void combineSection(const Session& session) {
    Owner owner = shownStructs(session, Section::Combine).front().owner;
    owner.labelOf = [&](const ParamRow& row, const EnumRow& choice) {
        const bool isNone =
            session.look.selection.unit == 0 && row.key.starts_with("source") && isPrevious(choice);
        return std::string(isNone ? N_("No unit before") : choice.label);
    };
    for (const Half& half : halves) {
        if (&half != halves.data())
            ImGui::Separator();
        drawHalf(session, owner, half);
    }
}

} // namespace texplorer::ui

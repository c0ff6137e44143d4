#include "app/ui/code/glsl_tab.h"

#include "app/ui/code/glsl_text.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

namespace texplorer::ui {

namespace {

using view::PassShader;
using view::ShaderMessage;
using view::ShaderStage;

struct StageRow {
    ShaderStage stage;
    const char* label;
    const char* help;
};
constexpr std::array stageRows{
    StageRow{ShaderStage::Vertex, N_("Vertex"),
             N_("Runs once for each vertex: coordinates, texgen, lighting")},
    StageRow{ShaderStage::Fragment, N_("Fragment"),
             N_("Runs for each pixel: the lookups and the environment")},
};

ImU32 tintOf(GlslToken::Kind kind) {
    const std::array<ImU32, 4> tints{color::text, color::keyword, color::uniform, color::dim};
    return tints.at(static_cast<std::size_t>(kind));
}

const glsl::StageSource& sourceOf(const PassShader& shader, ShaderStage stage) {
    return stage == ShaderStage::Vertex ? shader.source.vertex : shader.source.fragment;
}

void showLine(GlslTabState& state, const ShaderMessage& message) {
    if (!message.stage || message.line == 0)
        return;
    state.stage = *message.stage;
    state.wantedLine = message.line;
}

/// The choice of the stage, and buttons for the source.
void toolRow(const Session& session, GlslTabState& state, const PassShader& shader) {
    for (const StageRow& row : stageRows) {
        if (flatButton(label(row.label), state.stage == row.stage))
            state.stage = row.stage;
        item(std::string("stage:") + row.label, row.help);
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x / 2);
    }
    const float width = buttonWidth(N_("Copy"));
    const Sentence pass(N_("pass {0}"), session.look.selection.pass);
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(tr(pass).c_str()).x + 2 * width) {
        dimText(pass);
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (button("Copy", "glsl:copy", "Copies the source of the stage as passed to the driver"))
        ImGui::SetClipboardText(sourceOf(shader, state.stage).text.c_str());
}

/// The messages of the compiler, if any: a click goes to the line.
void drawLog(GlslTabState& state, const PassShader& shader) {
    if (shader.log.empty())
        return;
    ImGui::PushTextWrapPos(0);
    int number = 0;
    for (const ShaderMessage& message : shader.log) {
        text(message.sentence, color::problem);
        noteItem(fmt::format("message:{}", number++));
        if (message.line > 0 && ImGui::IsItemHovered())
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (ImGui::IsItemClicked())
            showLine(state, message);
    }
    dimText("The previous shaders are used until this is fixed.");
    ImGui::PopTextWrapPos();
}

bool isBlamed(const PassShader& shader, ShaderStage stage, int line) {
    return std::ranges::any_of(shader.log, [&](const ShaderMessage& message) {
        return message.stage == stage && message.line == line;
    });
}

/// A visible line: a line of the source, or a part of one that is too long.
struct Row {
    std::size_t line;
    std::string_view part;
    std::size_t indent; ///< in columns; 0 for the first part of a line, and only for it
};

std::vector<Row> wrapped(const std::vector<std::string_view>& lines, std::size_t columns) {
    std::vector<Row> rows;
    rows.reserve(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t indent = hangingIndent(lines[i], columns);
        for (const std::string_view part : wrapLine(lines[i], columns, indent))
            rows.push_back({i, part, part.data() == lines[i].data() ? 0 : indent});
    }
    return rows;
}

void drawNumber(std::size_t number, const std::string& digits) {
    const std::string shown = std::to_string(number);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::CalcTextSize(digits.c_str()).x -
                         ImGui::CalcTextSize(shown.c_str()).x);
    plainText(shown, color::faint);
    ImGui::SameLine(0, 0);
}

/// The tokens of a line that are in a part of it.
void drawPart(const std::vector<GlslToken>& tokens, std::string_view part, float left) {
    ImGui::SetCursorPosX(left);
    for (const GlslToken& token : tokens) {
        const char* begin = std::max(token.text.data(), part.data());
        const char* end = std::min(token.text.data() + token.text.size(), part.data() + part.size());
        if (begin >= end)
            continue;
        plainText({begin, static_cast<std::size_t>(end - begin)}, tintOf(token.kind));
        ImGui::SameLine(0, 0);
    }
    ImGui::NewLine();
}

void drawSource(GlslTabState& state, const PassShader& shader) {
    const glsl::StageSource& source = sourceOf(shader, state.stage);
    const std::vector<std::string_view> lines = linesOf(source.text);
    const GlslNames uniforms = uniformsOf(source.text);
    ImGui::BeginChild("source", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
    ImGui::PushFont(codeFont());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ImGui::GetFontSize() * 0.12F});
    const float letter = ImGui::CalcTextSize("M").x;
    const std::string digits = std::to_string(lines.size());
    const float gutter = letter * static_cast<float>(digits.size() + 2);
    const auto columns =
        static_cast<std::size_t>(std::max(16.0F, (ImGui::GetContentRegionAvail().x - gutter) / letter));
    const std::vector<Row> rows = wrapped(lines, columns);
    const float height = ImGui::GetTextLineHeightWithSpacing();
    if (state.wantedLine > 0) {
        const auto wanted = std::ranges::find(rows, static_cast<std::size_t>(state.wantedLine), &Row::line);
        ImGui::SetScrollY(static_cast<float>(wanted - rows.begin()) * height - ImGui::GetWindowHeight() / 2);
    }
    state.wantedLine = 0;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), height);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Row& row = rows[static_cast<std::size_t>(i)];
            const ImVec2 low = ImGui::GetCursorScreenPos();
            if (isBlamed(shader, state.stage, static_cast<int>(row.line) + 1))
                ImGui::GetWindowDrawList()->AddRectFilled(
                    low, {low.x + ImGui::GetWindowWidth(), low.y + height}, color::blamed);
            ImGui::BeginGroup();
            const float left = ImGui::GetCursorPosX() + gutter + letter * static_cast<float>(row.indent);
            if (row.indent == 0)
                drawNumber(row.line + 1, digits);
            drawPart(glslTokens(lines[row.line], uniforms), row.part, left);
            ImGui::EndGroup();
            if (row.indent == 0)
                noteItem(fmt::format("glsl:{}", row.line + 1));
            if (row.line < source.lines.size())
                helpTip(Sentence("{0}:{1}", ProperName{source.lines[row.line].file},
                                 source.lines[row.line].line));
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

} // namespace

void drawGlslTab(const Session& session, GlslTabState& state, const Pictures& pictures) {
    const auto pass = static_cast<std::size_t>(session.look.selection.pass);
    const std::shared_ptr<const PassShader> shader =
        pass < pictures.shaders.size() ? pictures.shaders[pass] : nullptr;
    if (!shader) {
        ImGui::PushTextWrapPos(0);
        Sentence reason = session.view.offered.whyNot(RendererKind::Shader);
        if (reason.empty())
            reason = presentScene(session).passes[pass].enabled ? Sentence("see the status bar")
                                                                : Sentence("pass {0} is not drawn", pass);
        dimText(Sentence("There is no shader: {0}.", reason));
        ImGui::PopTextWrapPos();
        return;
    }
    // Show a new error once: the file was just saved in an editor.
    if (shader->log.empty()) {
        state.shownLog.clear();
    } else if (state.shownLog != shader->log) {
        state.shownLog = shader->log;
        const auto placed =
            std::ranges::find_if(shader->log, [](const ShaderMessage& each) { return each.line > 0; });
        if (placed != shader->log.end())
            showLine(state, *placed);
    }
    toolRow(session, state, *shader);
    drawLog(state, *shader);
    drawSource(state, *shader);
}

} // namespace texplorer::ui

#include "app/ui/window/status_bar.h"

#include "app/ui/model/findings.h"
#include "app/ui/model/loads.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/base/printable.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

namespace {

/// "Reading brick.bmp · 34 %", and a way out.
void drawProgress(Session& session, const ImageLoader::Progress& progress) {
    using Step = ImageLoader::Step;
    if (ImGui::SmallButton("Cancel"))
        cancelLoad(session, progress.ticket);
    noteItem("cancel load");
    ImGui::SameLine();
    std::string text = progress.step == Step::Decoding ? "Decoding " : "Reading ";
    text += printable(progress.path.filename().string());
    if (progress.step == Step::Reading && progress.fileBytes > 0)
        text += fmt::format(" · {} %", progress.bytesRead * 100 / progress.fileBytes);
    ImGui::TextUnformatted(text.c_str());
    noteItem("loading");
    helpTip(progress.path.string());
}

/// The same for levels that are made of an image that is there already.
void drawProgress(Session& session, const LevelsWorker::Progress& progress) {
    if (ImGui::SmallButton("Cancel"))
        session.services.levels.cancel(progress.ticket);
    noteItem("cancel levels");
    ImGui::SameLine();
    std::string text = "Making the levels of " + printable(progress.what);
    if (progress.done > 0)
        text += fmt::format(" · {} %", static_cast<int>(100 * progress.done));
    ImGui::TextUnformatted(text.c_str());
    noteItem("making levels");
    helpTip("What was drawn before stays until they are there.");
}

void drawNotice(Session& session) {
    ImGui::PushStyleColor(ImGuiCol_Text, color::problem);
    const bool dismissed = ImGui::SmallButton("✕");
    noteItem("dismiss notice");
    ImGui::SameLine();
    if (!session.window.notice.file.empty()) {
        if (ImGui::SmallButton("Look inside"))
            lookInto(session, session.window.notice.file);
        noteItem("look inside");
        helpTip("Shows the bytes of the file and what they mean, up to where it is damaged");
        ImGui::SameLine();
    }
    fittedText(session.window.notice.text, color::problem);
    ImGui::PopStyleColor();
    noteItem("notice");
    helpTip(session.window.notice.text);
    if (dismissed)
        session.window.notice = {};
}

/// The first error or warning of the diagnosis: a click leads to its control, others mend it. Ways for which
/// a small window has no room are offered at the control.
void drawFinding(Session& session, const Finding& finding, std::size_t count) {
    const float forSentence = ImGui::GetFontSize() * 12;
    for (const Fix& fix : finding.fixes) {
        const float width = buttonWidth(fix.label.c_str()) + forSentence;
        if (&fix != &finding.fixes.front() && ImGui::GetContentRegionAvail().x < width)
            break;
        if (ImGui::SmallButton(fix.label.c_str()))
            session.window.wantedFix = fix;
        noteItem("fix:" + fix.label);
        helpTip(assignmentsOf(fix));
        ImGui::SameLine();
    }
    const std::string more = count > 1 ? fmt::format("1 of {}: ", count) : std::string();
    const std::string sentence = sentenceOf(finding);
    fittedText(more + sentence, color::problem);
    noteItem("finding");
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    helpTip(fmt::format("{}\n{}\nClick: show the setting", finding.path, sentence));
    if (ImGui::IsItemClicked())
        reveal(session, finding.path);
}

/// "llvmpipe · pretending: no-s3tc · 583 × 682 · 3.1 ms"
std::string factsOf(std::span<const ViewFrame> frames, const view::Capabilities& capabilities,
                    bool showsTime) {
    const ViewFrame& first = frames.front();
    const bool onlyReference = frames.size() == 1 && first.renderer == RendererKind::Reference;
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the name is enough here, the rest is in the tooltip.
    std::string facts = onlyReference ? std::string(rowOf(first.renderer).label)
                                      : capabilities.renderer.substr(0, capabilities.renderer.find(" ("));
    if (!onlyReference && !capabilities.pretending.empty())
        facts += " · pretending: " + capabilities.pretending;
    facts += fmt::format(" · {} × {}", first.frame.size.width, first.frame.size.height);
    if (!showsTime)
        return facts;
    for (const ViewFrame& view : frames)
        facts += view.whole ? fmt::format(" · {:.1f} ms", view.frame.milliseconds) : " · drawing";
    return facts;
}

/// What the host draws with, and what it lacks.
std::string hostText(const view::Capabilities& capabilities, const view::OfferedRenderers& offered) {
    std::string text = "No OpenGL";
    if (!capabilities.version.empty()) {
        text = fmt::format("{}\n{}\nOpenGL {}\nTextures up to {} texels wide", capabilities.vendor,
                           capabilities.renderer, capabilities.version, capabilities.maxTextureSize);
        if (offered.has(RendererKind::Fixed))
            text += fmt::format(", {} unit{}", capabilities.textureUnits,
                                capabilities.textureUnits == 1 ? "" : "s");
    }
    if (!capabilities.pretending.empty())
        text += "\nPretending: " + capabilities.pretending;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const std::string& reason = offered.whyNot(static_cast<RendererKind>(row.value));
        if (!reason.empty())
            text += fmt::format("\nNo {}: {}", row.label, reason);
    }
    return text;
}

} // namespace

void drawStatusBar(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout) {
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x,
                                                      (static_cast<float>(layout.status.height) - em) / 2});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    beginPanel("Status", layout.status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    ImGui::TextDisabled("%s", factsOf(pictures.frames, capabilities, session.window.showsFrameTime).c_str());
    noteItem("status");
    helpTip(hostText(capabilities, session.window.view.offered));
    ImGui::SameLine();
    ImGui::TextDisabled("·");
    ImGui::SameLine();
    const auto loading = session.services.files.progress();
    const auto making = session.services.levels.progress();
    if (loading) {
        drawProgress(session, *loading);
    } else if (making) {
        drawProgress(session, *making);
    } else if (!session.window.notice.text.empty()) {
        drawNotice(session);
    } else if (const auto problems = static_cast<std::size_t>(std::ranges::count_if(
                   session.document.findings,
                   [](const Finding& each) { return each.severity <= Severity::Warning; }));
               problems > 0 &&
               (pictures.problems.empty() || session.document.findings.front().reportedByRenderer)) {
        drawFinding(session, Finding(session.document.findings.front()), problems);
    } else if (!pictures.problems.empty()) {
        const std::size_t count = pictures.problems.size();
        const std::string more = count > 1 ? fmt::format("1 of {}: ", count) : std::string();
        fittedText(more + pictures.problems.front(), color::problem);
        noteItem("problem");
        std::string all;
        for (const std::string& each : pictures.problems)
            all += (all.empty() ? "" : "\n") + each;
        helpTip(all);
    } else {
        ImGui::TextDisabled("no GL error");
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

} // namespace texplorer::ui

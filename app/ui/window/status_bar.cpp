#include "app/ui/files/inspected_file.h"
#include "app/ui/files/loads.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/consequence.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/window_parts.h"
#include "texplorer/base/sentence.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

namespace {

/// Text in a line with large buttons.
void alignWithButtons() {
    if (targetHeight() > 0)
        ImGui::AlignTextToFramePadding();
}

void cancelButton(const Session& session, std::string_view name, const Action& cancel) {
    if (smallButton(label("Cancel")))
        act(session, cancel);
    noteItem(name);
    ImGui::SameLine();
}

/// "Reading brick.bmp · 34 %", and a button to cancel.
void drawProgress(const Session& session, const ImageLoader::Progress& progress) {
    using Step = ImageLoader::Step;
    cancelButton(session, "cancel:load", [ticket = progress.ticket](Session& s) { cancelLoad(s, ticket); });
    const std::string file = printable(progress.path.filename().string());
    const ProperName name{file};
    if (progress.step == Step::Decoding)
        text(Sentence("Decoding {0}", name));
    else if (progress.fileBytes == 0)
        text(Sentence("Reading {0}", name));
    else
        text(Sentence("Reading {0} · {1} %", name, progress.bytesRead * 100 / progress.fileBytes));
    item("loading", ProperName{progress.path.string()});
}

/// The same for levels that are made from a loaded image.
void drawProgress(const Session& session, const LevelsWorker::Progress& progress) {
    cancelButton(session, "cancel:levels",
                 [ticket = progress.ticket](Session& s) { workers(s).levels->cancel(ticket); });
    const auto percent = static_cast<int>(100 * progress.done);
    plainText(
        printable(tr(progress.done > 0 ? Sentence("Making the levels of {0} · {1} %", progress.what, percent)
                                       : Sentence("Making the levels of {0}", progress.what))));
    item("making levels", "The previous picture stays until they are ready.");
}

/// The same for a file that is being written.
void drawProgress(const Session& session, const FileProgress& progress) {
    cancelButton(session, "cancel:writing", [](Session& s) { workers(s).writing->cancel(); });
    const std::string file = printable(progress.file.filename().string());
    const ProperName name{file};
    const auto percent = static_cast<int>(100 * progress.share);
    if (progress.pictures > 0)
        text(Sentence("Drawing {0} · {1} of {2}", name, progress.picturesDrawn(),
                      Sentence::plural("{0} picture", "{0} pictures", progress.pictures)));
    else if (percent > 0)
        text(Sentence("Writing {0} · {1} %", name, percent));
    else
        text(Sentence("Writing {0}", name));
    item("writing file", ProperName{printable(progress.file.string())});
}

void drawNotice(const Session& session) {
    const ThemeColor ink = session.look.notice.isGood ? color::text : color::problem;
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    const bool dismissed = smallButton("✕");
    noteItem("dismiss notice");
    ImGui::SameLine();
    if (!session.look.notice.file.empty()) {
        if (smallButton(label("Look inside")))
            act(session, [file = session.look.notice.file](Session& s) { lookInto(s, file); });
        item("look inside", "Shows the bytes of the file and their meaning, up to the damage");
        ImGui::SameLine();
    }
    fittedText(session.look.notice.text, ink);
    ImGui::PopStyleColor();
    item("notice", session.look.notice.text);
    if (dismissed)
        act(session, [](Session& changed) { changed.look.notice = {}; });
}

/// The first error or warning of the diagnosis: a click goes to its control, other buttons fix it. Fixes that
/// do not fit into a small window are offered at the control.
void drawFinding(const Session& session, const Finding& finding, std::size_t count) {
    const float forSentence = ImGui::GetFontSize() * 12;
    for (const Fix& fix : finding.fixes) {
        const float width = buttonWidth(fix.label) + forSentence;
        if (&fix != &finding.fixes.front() && ImGui::GetContentRegionAvail().x < width)
            break;
        if (smallButton(label(fix.label).c_str()))
            applyFix(session, fix);
        item("fix:" + fix.label.english(), assignmentsOf(fix));
        ImGui::SameLine();
    }
    const Sentence sentence = shownSentence(finding.sentence);
    fittedText(count > 1 ? Sentence("1 of {0}: {1}", count, sentence) : sentence, color::problem);
    noteItem("finding");
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    helpTip(Sentence("{0}\n{1}\n{2}", ProperName{finding.path}, sentence, N_("Click: show the setting")));
    if (ImGui::IsItemClicked())
        act(session, [path = finding.path](Session& s) { reveal(s, path); });
}

/// "llvmpipe · pretending: no-s3tc · 583 × 682 · 3.1 ms"
Sentence factsOf(std::span<const ViewFrame> frames, const view::Capabilities& capabilities, bool showsTime) {
    const ViewFrame& first = frames.front();
    const bool onlyReference = frames.size() == 1 && first.renderer == RendererKind::Reference;
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the name is enough here, the tooltip has the rest.
    std::vector<Sentence> facts{
        onlyReference
            ? Sentence(rowOf(first.renderer).label)
            : ProperName{
                  std::string_view(capabilities.renderer).substr(0, capabilities.renderer.find(" ("))}};
    if (!onlyReference && !capabilities.pretending.empty())
        facts.push_back(Sentence("pretending: {0}", ProperName{capabilities.pretending}));
    facts.emplace_back(ProperName{fmt::format("{} × {}", first.frame.size.width, first.frame.size.height)});
    for (const ViewFrame& view : frames) {
        if (showsTime)
            facts.push_back(view.whole ? Sentence("{0:.1f} ms", view.frame.milliseconds)
                                       : N_("still drawing"));
    }
    return Sentence::joined("{0} · {1}", facts);
}

/// The host's driver, and what it lacks.
Sentence hostText(const view::Capabilities& capabilities, const view::OfferedRenderers& offered) {
    std::vector<Sentence> lines;
    if (capabilities.version.empty()) {
        lines.push_back(N_("No OpenGL"));
    } else {
        lines = {ProperName{capabilities.vendor}, ProperName{capabilities.renderer},
                 Sentence("OpenGL {0}", ProperName{capabilities.version}),
                 Sentence("Textures up to {0} texels wide", capabilities.maxTextureSize)};
        if (offered.has(RendererKind::Fixed))
            lines.push_back(
                Sentence::plural("{0} texture unit", "{0} texture units", capabilities.textureUnits));
    }
    if (!capabilities.pretending.empty())
        lines.push_back(Sentence("Pretending: {0}", ProperName{capabilities.pretending}));
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto& reason = offered.whyNot(static_cast<RendererKind>(row.value));
        if (!reason.empty())
            lines.push_back(Sentence("No {0}: {1}", row.label, reason));
    }
    return Sentence::joined("{0}\n{1}", lines);
}

/// The problems of the renderers.
void drawProblems(std::span<const Sentence> problems) {
    const Sentence& first = problems.front();
    fittedText(problems.size() > 1 ? Sentence("1 of {0}: {1}", problems.size(), first) : first,
               color::problem);
    noteItem("problem");
    helpTip(Sentence::joined("{0}\n{1}", problems));
}

/// The most important message: problems go before the result of a probed pixel.
void drawNews(const Session& session, const Pictures& pictures) {
    const std::vector<Finding>& findings = session.document.findings;
    const auto wrong = static_cast<std::size_t>(std::ranges::count_if(
        findings, [](const Finding& each) { return each.severity <= Severity::Warning; }));
    if (const auto loading = workers(session).files->progress())
        drawProgress(session, *loading);
    else if (const auto making = workers(session).levels->progress())
        drawProgress(session, *making);
    else if (const auto writing = workers(session).writing->progress())
        drawProgress(session, *writing);
    else if (!session.look.notice.text.empty())
        drawNotice(session);
    else if (wrong > 0 && (pictures.problems.empty() || findings.front().reportedByRenderer))
        drawFinding(session, findings.front(), wrong);
    else if (!pictures.problems.empty())
        drawProblems(pictures.problems);
    else if (const Sentence consequence = consequenceOf(session); !consequence.empty()) {
        fittedText(consequence, color::text);
        item("consequence", consequence);
    } else {
        fittedText(stateOf(session.document), color::dim);
        noteItem("state");
    }
}

/// In the middle: help for the item under the pointer.
void drawHint(const Hint& said, float from, float room) {
    if (said.words.empty())
        return;
    ImGui::SameLine(from);
    alignWithButtons();
    plainText(fitted(ProperName{printable(tr(said.words))}, room),
              said.isProblem ? color::problem : color::text);
    noteItem("hint");
}

constexpr float newsShare = 0.36F; ///< of the bar's width, while there is a hint
constexpr float factsShare = 0.3F; ///< at most

} // namespace

float hintRoom(const Layout& layout) {
    return static_cast<float>(layout.status.width) * (1 - newsShare - factsShare);
}

void drawStatusBar(const Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout, const Hint& said) {
    const float em = ImGui::GetFontSize();
    const float lineHeight = targetHeight() > 0 ? ImGui::GetFrameHeight() : em; // of buttons
    const float top = (static_cast<float>(layout.status.height) - lineHeight) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, top});
    beginBar(N_("Status"), layout.status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const float left = ImGui::GetCursorPosX();
    const float right = ImGui::GetContentRegionMax().x;
    const float whole = static_cast<float>(layout.status.width);
    const std::string facts =
        fitted(factsOf(pictures.frames, capabilities, session.window.showsFrameTime), whole * factsShare);
    const float factsFrom = right - ImGui::CalcTextSize(facts.c_str()).x;
    const float newsRoom = said.words.empty() ? factsFrom - left - em : whole * newsShare - em;
    ImGui::BeginChild("news", {std::max(1.0F, newsRoom), 0}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    alignWithButtons();
    drawNews(session, pictures);
    ImGui::EndChild();
    drawHint(said, left + newsRoom + em, factsFrom - left - newsRoom - 2 * em);
    ImGui::SameLine(factsFrom);
    alignWithButtons();
    ImGui::TextDisabled("%s", facts.c_str());
    item("status", hostText(capabilities, session.view.offered));
    ImGui::End();
}

} // namespace texplorer::ui

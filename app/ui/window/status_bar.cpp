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
#include "texplorer/base/count.h"
#include "texplorer/text/printable.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace texplorer::ui {

namespace {

void cancelButton(const Session& session, std::string_view name, const Action& cancel) {
    if (ImGui::SmallButton(label("Cancel")))
        act(session, cancel);
    noteItem(name);
    ImGui::SameLine();
}

/// "Reading brick.bmp · 34 %", and a button to cancel.
void drawProgress(const Session& session, const ImageLoader::Progress& progress) {
    using Step = ImageLoader::Step;
    cancelButton(session, "cancel:load", [ticket = progress.ticket](Session& s) { cancelLoad(s, ticket); });
    const std::string name = printable(progress.path.filename().string());
    if (progress.step == Step::Decoding)
        text(Sentence("Decoding {0}", name));
    else if (progress.fileBytes == 0)
        text(Sentence("Reading {0}", name));
    else
        text(Sentence("Reading {0} · {1} %", name, progress.bytesRead * 100 / progress.fileBytes));
    item("loading", progress.path.string());
}

/// The same for levels that are made from a loaded image.
void drawProgress(const Session& session, const LevelsWorker::Progress& progress) {
    cancelButton(session, "cancel:levels",
                 [ticket = progress.ticket](Session& s) { workers(s).levels->cancel(ticket); });
    const std::string what = printable(progress.what);
    text(progress.done > 0
             ? Sentence("Making the levels of {0} · {1} %", what, static_cast<int>(100 * progress.done))
             : Sentence("Making the levels of {0}", what));
    item("making levels", "The previous picture stays until they are ready.");
}

/// The same for a file that is being written.
void drawProgress(const Session& session, const FileProgress& progress) {
    cancelButton(session, "cancel:writing", [](Session& s) { workers(s).writing->cancel(); });
    const std::string name = printable(progress.file.filename().string());
    const auto percent = static_cast<int>(100 * progress.share);
    if (progress.pictures > 0)
        text(Sentence("Drawing {0} · {1} of {2}", name, progress.picturesDrawn(),
                      countOf(progress.pictures, "picture")));
    else if (percent > 0)
        text(Sentence("Writing {0} · {1} %", name, percent));
    else
        text(Sentence("Writing {0}", name));
    item("writing file", printable(progress.file.string()));
}

void drawNotice(const Session& session) {
    const ThemeColor ink = session.look.notice.isGood ? color::text : color::problem;
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    const bool dismissed = ImGui::SmallButton("✕");
    noteItem("dismiss notice");
    ImGui::SameLine();
    if (!session.look.notice.file.empty()) {
        if (ImGui::SmallButton(label("Look inside")))
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
        const float width = buttonWidth(fix.label.c_str()) + forSentence;
        if (&fix != &finding.fixes.front() && ImGui::GetContentRegionAvail().x < width)
            break;
        if (ImGui::SmallButton(label(fix.label).c_str()))
            applyFix(session, fix);
        item("fix:" + fix.label, assignmentsOf(fix));
        ImGui::SameLine();
    }
    const std::string sentence = sentenceOf(finding);
    fittedText(count > 1 ? Sentence("1 of {0}: {1}", count, sentence) : Sentence(sentence), color::problem);
    noteItem("finding");
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    helpTip(Sentence("{0}\n{1}\n{2}", finding.path, sentence, "Click: show the setting"));
    if (ImGui::IsItemClicked())
        act(session, [path = finding.path](Session& s) { reveal(s, path); });
}

/// "llvmpipe · pretending: no-s3tc · 583 × 682 · 3.1 ms"
std::string factsOf(std::span<const ViewFrame> frames, const view::Capabilities& capabilities,
                    bool showsTime) {
    const ViewFrame& first = frames.front();
    const bool onlyReference = frames.size() == 1 && first.renderer == RendererKind::Reference;
    // "llvmpipe (LLVM 15.0.6, 256 bits)": the name is enough here, the tooltip has the rest.
    std::string facts = onlyReference ? std::string(rowOf(first.renderer).label)
                                      : capabilities.renderer.substr(0, capabilities.renderer.find(" ("));
    if (!onlyReference && !capabilities.pretending.empty())
        facts += " · " + fmt::format("pretending: {}", capabilities.pretending);
    facts += fmt::format(" · {} × {}", first.frame.size.width, first.frame.size.height);
    if (!showsTime)
        return facts;
    for (const ViewFrame& view : frames)
        facts += " · " + (view.whole ? fmt::format("{:.1f} ms", view.frame.milliseconds) : "still drawing");
    return facts;
}

/// The host's driver, and what it lacks.
std::string hostText(const view::Capabilities& capabilities, const view::OfferedRenderers& offered) {
    std::string text = "No OpenGL";
    if (!capabilities.version.empty()) {
        text = fmt::format("{}\n{}\n", capabilities.vendor, capabilities.renderer);
        text += fmt::format("OpenGL {}", capabilities.version) + "\n";
        text += fmt::format("Textures up to {} texels wide", capabilities.maxTextureSize);
        if (offered.has(RendererKind::Fixed))
            text += "\n" + countOf(capabilities.textureUnits, "texture unit");
    }
    if (!capabilities.pretending.empty())
        text += "\n" + fmt::format("Pretending: {}", capabilities.pretending);
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const std::string& reason = offered.whyNot(static_cast<RendererKind>(row.value));
        if (!reason.empty())
            text += "\n" + fmt::format("No {}: {}", row.label, reason);
    }
    return text;
}

/// The problems of the renderers.
void drawProblems(std::span<const std::string> problems) {
    const std::string& first = problems.front();
    fittedText(problems.size() > 1 ? Sentence("1 of {0}: {1}", problems.size(), first) : Sentence(first),
               color::problem);
    noteItem("problem");
    helpTip(fmt::format("{}", fmt::join(problems, "\n")));
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
    else if (const std::string consequence = consequenceOf(session); !consequence.empty()) {
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
    plainText(fitted(printable(said.words), room), said.isProblem ? color::problem : color::text);
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
    const float top = (static_cast<float>(layout.status.height) - em) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, top});
    beginBar("Status", layout.status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
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
    drawNews(session, pictures);
    ImGui::EndChild();
    drawHint(said, left + newsRoom + em, factsFrom - left - newsRoom - 2 * em);
    ImGui::SameLine(factsFrom);
    ImGui::TextDisabled("%s", facts.c_str());
    item("status", hostText(capabilities, session.view.offered));
    ImGui::End();
}

} // namespace texplorer::ui

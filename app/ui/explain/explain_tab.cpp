#include "app/ui/explain/explain_tab.h"

#include "app/ui/explain/step_rows.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/explaining.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/same_line.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

using reference::Explanation;
using reference::FragmentExplanation;
using reference::FragmentSteps;
using reference::Step;
using reference::StepRow;

constexpr float minPipeline = 46; // in heights of the text: narrower panels have a list

/// Its title, and what became of it unless it was drawn.
Sentence titleOf(const FragmentSteps& fragment) {
    return fragment.drawn ? fragment.title : Sentence("{0}: {1}", fragment.title, fragment.outcome);
}

/// Counted like texshot probe --at: from the upper left.
Sentence pixelText(const Explanation& explanation) {
    return Sentence("Pixel {0},{1}", explanation.pixel.x, explanation.height - 1 - explanation.pixel.y);
}

void offerMethod(const Session& session, reference::AnisotropyMethod method) {
    const bool line = method == reference::AnisotropyMethod::Line;
    const char* offer = line ? N_("Compare by line") : N_("Compare by ellipse");
    hangingText(
        line ? N_("Drivers may filter anisotropically in different ways. This one averages one level along a "
                  "line.")
             : N_("Drivers may filter anisotropically in different ways. This one averages over an ellipse."),
        color::text);
    noteItem("explain:method");
    const float button = buttonWidth(offer);
    sameLineFor(button, ImGui::GetStyle().ItemSpacing.x);
    if (smallButton(label(offer)))
        act(session, [method](Session& changed) { changed.view.anisotropy = method; });
    item("explain:use method", texplorer::rowOf(method).help);
}

/// The same as drawRows, in one line.
void drawInLine(const std::vector<StepRow>& rows, float reserved) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    for (const StepRow& row : rows) {
        float width = ImGui::GetTextLineHeight() + ImGui::CalcTextSize(tr(row.label).c_str()).x;
        for (const reference::StepCell& cell : row.cells)
            width += gap + ImGui::CalcTextSize(tr(cell.text).c_str()).x;
        sameLineFor(width + reserved, ImGui::GetFontSize() * 1.2F);
        swatch(row.swatch);
        text(row.label, color::dim);
        for (const reference::StepCell& cell : row.cells) {
            if (cell.text.empty())
                continue;
            ImGui::SameLine(0, gap);
            text(cell.text, tintOf(cell.ink));
        }
    }
}

/// At the right end of the line, or below if it does not fit.
void pixelButtons(const Session& session) {
    const bool pinned = session.look.explaining.pinned != nullptr;
    const char* pin = pinned ? N_("Unpin") : N_("Pin");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = buttonWidth(pin) + gap + buttonWidth("Clear");
    const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ImGui::GetScrollX();
    if (end + gap + width <= ImGui::GetContentRegionMax().x)
        ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (smallButton(label(pin))) {
        if (pinned)
            act(session, [](Session& changed) { changed.look.explaining.pinned.reset(); });
        else
            act(session, pinPixel);
    }
    item(pinned ? "explain:unpin" : "explain:pin",
         pinned ? N_("Unpins the pixel kept for comparison.")
                : N_("Keeps this pixel. The next one, or the same one after a change, is shown next to it "
                     "with the differences marked."));
    sameLineFor(buttonWidth("Clear"), gap);
    if (smallButton(label("Clear")))
        act(session, [](Session& s) {
            s.look.explaining.pixel.reset();
            s.look.explaining.pinned.reset();
            clearTexel(s);
        });
    noteItem("explain:clear");
}

void drawHead(const Session& session, const Pictures& pictures, const Explanation& explanation, bool wide) {
    text(pixelText(explanation), color::probed);
    item("explain:pixel",
         Sentence("Counted from the upper left. In OpenGL's window coordinates, from the lower left: "
                  "{0},{1}. Click in the picture or press an arrow key for another pixel, with Shift for "
                  "ten pixels.",
                  explanation.pixel.x, explanation.pixel.y));
    const Comparison comparison = compareRenderers(session, pictures, explanation);
    if (wide) {
        drawInLine(comparison.rows, buttonWidth(N_("Unpin")) + buttonWidth("Clear") + ImGui::GetFontSize());
        pixelButtons(session);
    } else {
        pixelButtons(session);
        drawRows(comparison.rows);
    }
    for (const std::string& label : comparison.compared)
        noteItem("explain:compared " + label);
    const DriverFacts& driver = session.document.diagnosis.driver;
    const reference::AnisotropyMethod method = reference::anisotropyMethodOf(driver.renderer, driver.version);
    if (comparison.most > session.view.tolerance && method != session.view.anisotropy &&
        mayDifferByMethod(session, explanation))
        offerMethod(session, method);
}

/// The number of pixels that read the selected texel.
Sentence readersOf(const Explaining& asked) {
    if (!asked.answer || !asked.answer->contributions || asked.answer->request.texel != asked.texel)
        return N_("searching its pixels…");
    const auto& found = *asked.answer->contributions;
    if (!found)
        return describe(found.error());
    const auto count = std::ranges::count_if(found->weights, [](float weight) { return weight > 0; });
    return count == 0   ? N_("no visible pixel reads it")
           : count == 1 ? N_("one pixel reads it")
                        : Sentence("{0} pixels read it", count);
}

void drawTexelLine(const Session& session) {
    const Explaining& asked = session.look.explaining;
    if (!asked.texel)
        return;
    const auto& [level, index] = asked.texel->texel;
    const Sentence words(N_("Texel {0}, {1} of level {2}: {3}"), index.x, index.y, level, readersOf(asked));
    if (smallButton("✕##texel"))
        act(session, clearTexel);
    item("explain:clear texel", "Unpicks this texel (Escape)");
    ImGui::SameLine();
    hangingText(words, color::chosen);
    noteItem("explain:texel");
}

/// The index of the visible fragment.
std::size_t seenFragment(const Explanation& explanation) {
    const FragmentExplanation* seen = explanation.seen();
    return seen ? static_cast<std::size_t>(seen - explanation.fragments.data()) : 0;
}

/// The choice among the fragments that cover the pixel. Of a single one of a later pass, what it is: the
/// panels show another pass.
void chooseFragment(ExplainTabState& state, const Explanation& explanation,
                    const std::vector<FragmentSteps>& fragments, std::size_t shown) {
    if (fragments.size() == 1 && explanation.fragments.front().pass > 0)
        dimText(titleOf(fragments.front()));
    if (fragments.size() < 2)
        return;
    labelText(Sentence("{0} fragments cover it:", explanation.fragmentCount), color::dim);
    ImGui::SameLine();
    const Sentence title = titleOf(fragments[shown]);
    const float arrow = ImGui::GetFrameHeight();
    const float width = std::min(ImGui::CalcTextSize(tr(title).c_str()).x + arrow + ImGui::GetFontSize(),
                                 ImGui::GetContentRegionAvail().x);
    ImGui::SetNextItemWidth(width);
    const std::string preview = fitted(title, width - arrow - ImGui::GetFontSize());
    const bool open = beginCombo("##fragment", preview.c_str());
    noteItem("explain:fragments");
    if (preview != tr(title))
        helpTip(title);
    if (!open)
        return;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(label(titleOf(fragments[i])).c_str(), i == shown)) {
            state.fragment = i;
            state.fragmentOf = explanation.pixel;
        }
        noteItem(fmt::format("explain:fragment {}", i));
        ImGui::PopID();
    }
    endCombo();
}

Lane laneOf(const Explanation& explanation, const std::vector<FragmentSteps>& fragments, std::size_t shown,
            Sentence title) {
    const FragmentExplanation& fragment = explanation.fragments[shown];
    return {std::move(title), fragment, fragments[shown], cardsOf(fragment, fragments[shown])};
}

void drawLanes(ExplainTabState& state, const Explanation* pinned,
               const std::vector<FragmentSteps>& pinnedFragments, const Explanation& explanation,
               const std::vector<FragmentSteps>& fragments) {
    const bool isChosen =
        state.fragmentOf == explanation.pixel && state.fragment < explanation.fragments.size();
    const std::size_t shown = isChosen ? state.fragment : seenFragment(explanation);
    chooseFragment(state, explanation, fragments, shown);
    std::vector<Lane> lanes;
    if (pinned && !pinnedFragments.empty())
        lanes.push_back(laneOf(*pinned, pinnedFragments, seenFragment(*pinned),
                               Sentence("Pinned: {0}", pixelText(*pinned))));
    lanes.push_back(
        laneOf(explanation, fragments, shown, lanes.empty() ? Sentence() : pixelText(explanation)));
    drawPipeline(state.open, lanes);
}

bool differsFrom(const FragmentSteps* other, const Step& step) {
    if (!other)
        return false;
    const auto same = std::ranges::find_if(
        other->steps, [&](const Step& each) { return each.kind == step.kind && each.unit == step.unit; });
    return same == other->steps.end() || same->summary != step.summary;
}

void drawListedStep(const Step& step, bool openAtFirst, bool severalUnits, bool differs) {
    const Sentence title =
        step.unit < 0 || !severalUnits ? step.title : Sentence("{0}, unit {1}", step.title, step.unit);
    ImGui::PushID(static_cast<int>(step.kind) * 8 + step.unit);
    // The texels are the most important.
    ImGui::SetNextItemOpen(openAtFirst && step.kind == reference::StepKind::Texels, ImGuiCond_FirstUseEver);
    const bool hasRows = !step.rows.empty();
    const bool open = ImGui::TreeNodeEx(
        "step", nodeHeight() | ImGuiTreeNodeFlags_SpanAvailWidth | (hasRows ? 0 : ImGuiTreeNodeFlags_Leaf),
        "%s", tr(title).c_str());
    noteItem("explain:" + title.english());
    ImGui::SameLine();
    swatch(step.swatch);
    if (differs) { // a bar: not marked only by a colour
        const float em = ImGui::GetFontSize();
        const ImVec2 low = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + em * 0.25F, low.y + em}, color::changed);
        ImGui::Dummy({em * 0.25F, em});
        noteItem("explain:differs " + title.english());
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    const bool idle = step.kind == reference::StepKind::IdleUnit;
    hangingText(step.summary, differs ? color::changed : idle ? color::problem : color::dim);
    noteItem("explain:summary of " + title.english());
    if (open) {
        ImGui::TreePop(); // before the rows: they need the width
        drawRows(step.rows);
        noteItem("explain:rows of " + title.english());
    }
    ImGui::PopID();
}

void drawFragment(const FragmentSteps& fragment, const FragmentExplanation& explained, std::size_t index,
                  bool seen, const FragmentSteps* other) {
    ImGui::PushID(seen ? -1 : static_cast<int>(index));
    ImGui::SetNextItemOpen(seen, ImGuiCond_FirstUseEver);
    const Sentence title = titleOf(fragment);
    ImGui::PushStyleColor(ImGuiCol_Text, fragment.drawn ? color::text : color::dim);
    const float room = ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX() - ImGui::GetCursorPosX() -
                       ImGui::GetTreeNodeToLabelSpacing() - ImGui::GetFontSize() * 0.5F;
    const std::string shown = fitted(title, room);
    const bool open = ImGui::CollapsingHeader((shown + "###fragment").c_str());
    if (shown != tr(title))
        helpTip(title);
    ImGui::PopStyleColor();
    noteItem(fmt::format("explain:fragment {}", index));
    for (const Step& step : fragment.steps) {
        if (open)
            drawListedStep(step, seen, explained.units.size() + explained.idle.size() > 1,
                           seen && differsFrom(other, step));
    }
    ImGui::PopID();
}

/// Every fragment of a pixel with its steps one below the other: first the visible one, then the others in
/// drawing order. Differences of the visible one from `other` are marked; nullptr: none are.
void drawFragmentList(const reference::Explanation& explanation, const std::vector<FragmentSteps>& fragments,
                      const FragmentSteps* other = nullptr) {
    const FragmentExplanation* seen = explanation.seen();
    for (const bool wanted : {true, false}) {
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            if ((seen == &explanation.fragments[i]) == wanted)
                drawFragment(fragments[i], explanation.fragments[i], i, wanted, other);
        }
    }
}

void drawLists(const Explanation* pinned, const std::vector<FragmentSteps>& pinnedFragments,
               const Explanation& explanation, const std::vector<FragmentSteps>& fragments) {
    const bool comparable = pinned && pinned->seen();
    drawFragmentList(explanation, fragments, comparable ? &pinnedFragments[seenFragment(*pinned)] : nullptr);
    if (!pinned)
        return;
    ImGui::Separator();
    ImGui::PushID("pinned");
    text(Sentence("Pinned: {0}", pixelText(*pinned)), color::dim);
    noteItem("explain:pinned");
    drawFragmentList(*pinned, pinnedFragments);
    ImGui::PopID();
}

/// Instructions, and what they will show.
void drawInvitation(const Session& session, const Pictures& pictures, bool wide) {
    const auto [width, height] = pictures.frames.front().frame.size;
    wrappedText("Why does a pixel have its colour? Click one in the view to see every step of OpenGL, in "
                "order.");
    noteItem("explain:none");
    if (smallButton(label("Explain the pixel in the middle")))
        act(session, [middle = reference::PixelPlace{width / 2, height / 2}](Session& changed) {
            changed.look.explaining.pixel = middle;
        });
    noteItem("explain:middle");
    if (wide) {
        ImGui::Dummy({0, ImGui::GetFontSize() * 0.3F});
        drawStages();
    }
}

} // namespace

void drawExplainTab(const Session& session, ExplainTabState& state, const Pictures& pictures) {
    ImGui::BeginChild("explain", {0, 0});
    const bool wide = ImGui::GetContentRegionAvail().x >= minPipeline * ImGui::GetFontSize();
    const auto& answer = session.look.explaining.answer;
    const Explanation* explanation = explanationOf(session);
    if (!session.look.explaining.pixel) {
        drawInvitation(session, pictures, wide);
        drawTexelLine(session);
    } else if (!explanation) {
        if (answer && answer->explanation && !*answer->explanation)
            wrappedText(describe(answer->explanation->error()));
        else
            dimText("The texture's levels are being made…");
        noteItem("explain:waiting");
    } else {
        drawHead(session, pictures, *explanation, wide);
        drawTexelLine(session);
        const auto& fragments = state.steps.of(answer);
        const Explanation* pinned = pinnedExplanation(session);
        const auto& pinnedFragments =
            pinned ? state.pinnedSteps.of(session.look.explaining.pinned) : state.pinnedSteps.steps;
        if (const Sentence cut = cutSentence(*explanation); !cut.empty()) {
            wrappedText(cut);
            noteItem("explain:cut");
        }
        if (fragments.empty())
            wrappedText("No model covers it, so it shows the background.");
        if (wide && !fragments.empty())
            drawLanes(state, pinned, pinnedFragments, *explanation, fragments);
        else
            drawLists(pinned, pinnedFragments, *explanation, fragments);
    }
    ImGui::EndChild();
}

} // namespace texplorer::ui

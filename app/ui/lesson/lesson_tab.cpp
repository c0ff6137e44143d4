#include "app/ui/lesson/lesson_tab.h"

#include "app/ui/files/asking.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/lesson_list.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/state/lesson_records.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

using lesson::Match;
using lesson::Predict;
using lesson::Step;
using lesson::Try;

/// Scrolls just enough to make the verdict visible, from `top` to the cursor; only its beginning if it is
/// higher than the window. Call it after the verdict.
void scrollToVerdict(const LessonRun& run, float top) {
    if (run.wantedScroll != LessonRun::Scroll::Verdict)
        return;
    const float below = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y - ImGui::GetWindowHeight();
    ImGui::SetScrollY(std::min(std::max(ImGui::GetScrollY(), below), top));
}

void space() {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.3F});
}

void goToStep(const Session& session, std::size_t step) {
    act(session, [step](Session& s) { goToLessonStep(s, step); });
}

void giveAnswer(const Session& session, std::size_t wanted) {
    act(session, [wanted](Session& s) { answerQuestion(s, wanted); });
}

/// A mark for each step, filled if the step is done; a click goes to the step.
void stepMarks(const Session& session, const LessonRun& run) {
    const float em = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::size_t count = run.lesson.steps.size();
    const float width = std::min(em * 1.1F, ImGui::GetContentRegionAvail().x / static_cast<float>(count));
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0)
            ImGui::SameLine(0, 0);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (ImGui::InvisibleButton(fmt::format("mark {}", i).c_str(), {width, em}))
            goToStep(session, i);
        item(fmt::format("lesson step:{}", i + 1),
             Sentence("{0}. {1}", i + 1, ProperName{run.text(run.lesson.steps[i].title)}));
        const ImVec2 middle(low.x + width / 2, low.y + em / 2);
        const float radius = width * 0.3F;
        const bool isHere = i == run.step;
        if (isStepDone(session.settings, run.key, i))
            draw.AddCircleFilled(middle, radius, isHere ? color::chosen : color::accent);
        else
            draw.AddCircle(middle, radius, isHere ? color::chosen : color::dim, 0, em * 0.1F);
        if (isHere)
            draw.AddLine({low.x + width * 0.15F, low.y + em}, {low.x + width * 0.85F, low.y + em},
                         color::chosen, em * 0.12F);
    }
}

/// A picture of the step in the place of the last item, with a frame; only the frame until it is ready.
void smallPicture(const Pictures& pictures, const LessonRun& run, std::size_t number, ImU32 frame) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    draw.AddRectFilled(low, high, color::ground);
    const auto image = run.pictures && number < run.pictures->size() ? (*run.pictures)[number] : nullptr;
    if (image && pictures.setBlending)
        draw.AddCallback(pictures.setBlending, nullptr);
    if (image)
        drawImage(pictures, image, low, high);
    if (image && pictures.setBlending)
        draw.AddCallback(pictures.setBlending, &draw);
    draw.AddRect(low, high, frame, 0, 0, std::max(1.0F, ImGui::GetFontSize() * 0.12F));
}

constexpr float pictureShape =
    static_cast<float>(lesson::smallHeight) / static_cast<float>(lesson::smallWidth);

/// The colour of an answer: of the chosen one, or else `usual`.
ImU32 answerInk(const LessonRun& run, const Predict& predict, std::size_t answer, ImU32 usual) {
    return run.answer != answer ? usual : answer == predict.right ? color::accent : color::problem;
}

/// The text of an answer, with a sign in addition to the colour.
std::string answerName(const LessonRun& run, const Predict& predict, std::size_t answer) {
    const std::string words = run.stepText(predict.answers[answer].text);
    if (run.answer != answer)
        return words;
    return fmt::format("{} {}", answer == predict.right ? "●" : "✕", words);
}

void answerPictures(const Session& session, const LessonRun& run, const Predict& predict,
                    const Pictures& pictures) {
    const float em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = em * 0.6F;
    const std::size_t columns = room > em * 40 ? predict.answers.size() : 2;
    const float width =
        std::min((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns), em * 16);
    float bottom = 0;
    ImVec2 low = ImGui::GetCursorPos();
    const float left = low.x;
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        ImGui::SetCursorPos(low);
        ImGui::PushID(static_cast<int>(i));
        ImGui::BeginGroup();
        if (ImGui::InvisibleButton("picture", {width, width * pictureShape}))
            giveAnswer(session, i);
        smallPicture(pictures, run, i,
                     ImGui::IsItemHovered() ? color::text : answerInk(run, predict, i, color::dim));
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
        plainText(answerName(run, predict, i), answerInk(run, predict, i, color::text));
        ImGui::PopTextWrapPos();
        ImGui::EndGroup();
        noteItem(fmt::format("answer:{}", i + 1));
        bottom = std::max(bottom, ImGui::GetCursorPosY());
        ImGui::PopID();
        low.x += width + gap;
        if ((i + 1) % columns == 0)
            low = {left, bottom};
    }
    ImGui::SetCursorPos({left, bottom});
}

void answerSentences(const Session& session, const LessonRun& run, const Predict& predict) {
    const float em = ImGui::GetFontSize();
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const float room = ImGui::GetContentRegionAvail().x - em * 0.8F;
        const std::string lines = wrappedLines(answerName(run, predict, i), room);
        const ImVec2 size = ImGui::CalcTextSize(lines.c_str());
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float above = std::max(em * 0.25F, (targetHeight() - size.y) / 2);
        if (ImGui::Button("##answer", {room + em * 0.8F, size.y + 2 * above}))
            giveAnswer(session, i);
        noteItem(fmt::format("answer:{}", i + 1));
        ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), em, {low.x + em * 0.4F, low.y + above},
                                            answerInk(run, predict, i, color::text), lines.c_str());
        ImGui::PopID();
    }
}

void drawTask(const Session& /*session*/, const LessonRun& /*run*/, const std::monostate& /*task*/,
              const Pictures&) {}

void drawTask(const Session& /*session*/, const LessonRun& run, const Try& task, const Pictures&) {
    dimText("Try");
    plainWrappedText(run.stepText(task.task));
}

void drawTask(const Session& session, const LessonRun& run, const Predict& predict,
              const Pictures& pictures) {
    dimText("Predict");
    plainWrappedText(run.stepText(predict.question));
    space();
    if (std::ranges::any_of(predict.answers, [](const lesson::Answer& each) { return !each.edits.empty(); }))
        answerPictures(session, run, predict, pictures);
    else
        answerSentences(session, run, predict);
    if (!run.answer)
        return;
    const float top = ImGui::GetCursorPosY();
    space();
    if (*run.answer != predict.right) {
        wrappedText("Not this one. Look again, or try it in the window.", color::problem);
        noteItem("not this one");
    } else if (const std::string reason = run.reason(); reason.empty()) {
        dimText("Computing the numbers…");
    } else {
        plainWrappedText(reason, color::text);
        noteItem("reason");
    }
    scrollToVerdict(run, top);
}

void drawTask(const Session& session, const LessonRun& run, const Match& match, const Pictures& pictures) {
    dimText("Match");
    plainWrappedText(run.stepText(match.task));
    space();
    const float width = std::min(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 16);
    ImGui::Dummy({width, width * pictureShape});
    const bool passed = run.grade && run.grade->passed;
    const float top = ImGui::GetCursorPosY();
    smallPicture(pictures, run, 0, passed ? color::accent : color::dim);
    noteItem("picture to reach");
    if (passed) {
        plainWrappedText("● " + tr(std::string(N_("Solved: your picture matches."))), color::accent);
        noteItem("reached");
    } else if (run.grade) {
        dimWrappedText(Sentence("{0} % of the pixels still differ.", percentWrong(*run.grade)));
        noteItem("not reached");
    } else {
        dimText("Comparing…");
    }
    // It stays in place when disabled: it may have the keyboard focus.
    ImGui::BeginDisabled(passed);
    if (smallButton(label("Hint")))
        act(session, [](Session& changed) {
            if (changed.lesson)
                changed.lesson->wantsHint = true;
        });
    if (!passed)
        noteItem("match:hint");
    ImGui::EndDisabled();
    scrollToVerdict(run, top);
    if (passed || !run.wantsHint)
        return;
    ImGui::SameLine();
    if (!run.hint)
        return dimText("Searching…");
    if (!run.hint->hint)
        return;
    wrappedText(Sentence("Change {0}.", run.hint->hint->label));
    if (session.look.shownParam != run.hint->hint->path)
        act(session, [path = run.hint->hint->path](Session& changed) { changed.look.shownParam = path; });
}

/// The current step and the buttons to the others.
void stepButtons(const Session& session, const LessonRun& run) {
    ImGui::BeginDisabled(run.step == 0);
    if (ImGui::Button(label("Previous")))
        goToStep(session, run.step - 1);
    noteItem("lesson:Previous");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button(label("Restart step")))
        goToStep(session, run.step);
    noteItem("lesson:Restart step");
    ImGui::SameLine();
    const bool atEnd = run.step + 1 == run.lesson.steps.size();
    // A single button, so that it keeps the keyboard focus.
    const std::string on = tr(std::string(atEnd ? N_("All lessons") : N_("Next"))) + "###next";
    if (ImGui::Button(on.c_str())) {
        if (atEnd)
            act(session, [](Session& s) { closeLesson(s, KeepsTab::Yes); });
        else
            goToStep(session, run.step + 1);
    }
    noteItem("lesson:Next");
}

/// Text can be scrolled by the keyboard if no item has the focus and the lesson does not use the key.
void scrollByPages(const LessonRun& run) {
    if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) || ImGui::GetIO().WantTextInput ||
        run.heldKey)
        return;
    const float page = ImGui::GetWindowHeight() - ImGui::GetTextLineHeight() * 2;
    if (isKeyPressed(key::pageDown))
        ImGui::SetScrollY(std::min(ImGui::GetScrollY() + page, ImGui::GetScrollMaxY()));
    if (isKeyPressed(key::pageUp))
        ImGui::SetScrollY(std::max(ImGui::GetScrollY() - page, 0.0F));
}

void drawStep(const Session& session, const LessonRun& run, const Pictures& pictures) {
    const Step& step = run.lesson.steps[run.step];
    const float buttons = ImGui::GetFrameHeightWithSpacing();
    // Flattened: the keyboard moves between the answers and the buttons below.
    ImGui::BeginChild("step", {0, -buttons}, false, ImGuiWindowFlags_NavFlattened);
    if (run.wantedScroll == LessonRun::Scroll::Top)
        ImGui::SetScrollY(0);
    if (run.wantedScroll != LessonRun::Scroll::None) // first: an answer or another step scrolls again
        act(session, [done = run.wantedScroll](Session& changed) {
            if (changed.lesson && changed.lesson->wantedScroll == done)
                changed.lesson->wantedScroll = LessonRun::Scroll::None;
        });
    plainWrappedText(run.text(run.lesson.title), color::dim);
    if (run.step == 0 && !run.lesson.source.empty())
        plainWrappedText(run.text(run.lesson.source), color::dim);
    stepMarks(session, run);
    plainWrappedText(fmt::format("{}. {}", run.step + 1, run.text(step.title)), color::chosen);
    noteItem("lesson title");
    plainWrappedText(run.stepText(step.text));
    if (!run.start.fallback.empty())
        plainWrappedText(run.text(run.start.fallback), color::dim);
    for (const auto& note : imageNotes(run.start))
        dimWrappedText(note);
    space();
    drawLessonKeys(session, run);
    std::visit([&](const auto& task) { drawTask(session, run, task, pictures); }, step.task);
    scrollByPages(run);
    ImGui::EndChild();
    stepButtons(session, run);
}

void drawList(const Session& session) {
    ImGui::BeginChild("lessons", {}, false, ImGuiWindowFlags_NavFlattened);
    for (const LessonTitle& each :
         lessonTitles(catalogueInUse() ? catalogueInUse()->language() : Language::English)) {
        ImGui::PushID(each.name.c_str());
        const LessonProgress progress = progressOf(session.settings, each.name, each.steps);
        const std::string count = fmt::format("{} / {}", progress.done, progress.steps);
        const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(count.c_str()).x;
        beginEntries();
        if (ImGui::Selectable(each.title.c_str(), false, 0, {room - ImGui::GetFontSize(), 0}))
            act(session, [name = each.name](Session& s) { askLesson(s, name); });
        endEntries();
        noteItem("lesson:" + each.name);
        ImGui::SameLine(ImGui::GetCursorPosX() + room);
        dimText(count);
        plainWrappedText(each.about, color::dim);
        space();
        ImGui::PopID();
    }
    ImGui::EndChild();
}

} // namespace

void drawLessonTab(const Session& session, const Pictures& pictures) {
    if (session.lesson)
        drawStep(session, *session.lesson, pictures);
    else
        drawList(session);
}

} // namespace texplorer::ui

#include "app/ui/files/recording_file.h"
#include "app/ui/files/texshot_command.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/dialog_parts.h"
#include "texplorer/base/sentence.h"
#include "texplorer/scene/animation.h"

#include <fmt/core.h>

#include <string>

namespace texplorer::ui {
namespace {

constexpr float numberWidth = 5.5F; // in heights of a letter

bool secondsField(const char* id, float& value, float min) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * numberWidth);
    const bool changed = dragFloat(id, value, 0.05F, min, maxKeyTime, secondsFormat().c_str());
    markDraggable();
    noteItem(fmt::format("record:{}", id + 2));
    return changed;
}

void extentField(const Session& session, const char* id, int RecordingChoice::*extent) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * numberWidth);
    int value = session.recording.*extent;
    if (dragInt(id, value, 1, 1, reference::maxPictureExtent))
        act(session, [extent, value](Session& changed) { changed.recording.*extent = value; });
    markDraggable();
    noteItem(fmt::format("record:{}", id + 2));
}

void formatLine(const Session& session) {
    lineName(N_("Format"));
    for (const animation::FormatRow& row : animation::formatRows) {
        if (&row != &animation::formatRows.front())
            ImGui::SameLine(0, ImGui::GetFontSize() * 0.8F);
        if (ImGui::RadioButton(std::string(row.name).c_str(), session.recording.format == row.format))
            act(session, [&row](Session& changed) { changed.recording.format = row.format; });
        item(fmt::format("record:{}", row.name),
             row.format == animation::Format::Gif
                 ? N_("Supported everywhere. At most 256 colours in each picture and 50 pictures a second.")
             : row.format == animation::Format::WebP
                 ? N_("Supported by browsers. Small files without losses.")
                 : N_("An animated PNG without losses."));
    }
}

void lengthLines(const Session& session) {
    const RecordingChoice& choice = session.recording;
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    lineName(N_("Begins at"));
    float begin = choice.begin;
    if (secondsField("##begin", begin, 0))
        act(session, [begin](Session& changed) { changed.recording.begin = begin; });
    lineName(N_("Length"));
    float seconds = recordedSeconds(session);
    if (secondsField("##seconds", seconds, 0.01F))
        act(session, [seconds](Session& changed) { changed.recording.seconds = seconds; });
    if (lengthOf(session.document.scene.timeline) > 0) {
        ImGui::SameLine(0, inner);
        ImGui::BeginDisabled(!choice.seconds);
        if (ImGui::Button(label("As the key frames")))
            act(session, [](Session& changed) { changed.recording.seconds.reset(); });
        ImGui::EndDisabled();
        item("record:as keys",
             "Up to the last key frame. If its values are those of the first one, the animation loops "
             "smoothly.");
    }
    lineName(N_("Pictures a second"));
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * numberWidth);
    float perSecond = choice.perSecond;
    if (dragFloat("##perSecond", perSecond, 0.2F, 1, 100, "%.4g"))
        act(session, [perSecond](Session& changed) { changed.recording.perSecond = perSecond; });
    markDraggable();
    noteItem("record:perSecond");
}

/// The properties of the animation, or why it is not possible.
void summary(const Session& session, const Result<Recording>& recording) {
    const ImVec2 from = ImGui::GetCursorPos();
    if (!recording) {
        wrappedText(describe(recording.error()), color::problem);
        noteItem("record:problem");
    } else if (!isAnimated(session.document.scene)) {
        wrappedText("Nothing moves in this scene. All pictures will be the same.");
        noteItem("record:still");
    } else {
        dimText(Sentence("{0}, drawn by the reference. The window stays usable meanwhile.",
                         Sentence::plural("{0} picture", "{0} pictures", recording->pictures())));
    }
    // The height does not depend on the text, so that the buttons stay in place.
    ImGui::SetCursorPos({from.x, from.y + ImGui::GetTextLineHeightWithSpacing() * 2.2F});
}

void copyCommand(Session& session) {
    const Result<std::string> command = animateCommand(session);
    if (!command)
        return say(session, Sentence("No command can draw this animation: {0}.", describe(command.error())));
    ImGui::SetClipboardText(command->c_str());
    tell(session, "Copied a command that draws this animation without a window.");
}

} // namespace

void drawRecord(const Session& session) {
    if (!beginModal("Record an animation"))
        return;
    const float em = ImGui::GetFontSize();
    ImGui::Dummy({em * 34, 0}); // wide enough for its sentences
    formatLine(session);
    lengthLines(session);
    lineName(N_("Each picture"));
    extentField(session, "##width", &RecordingChoice::width);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted("×");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    extentField(session, "##height", &RecordingChoice::height);
    ImGui::Dummy({0, em * 0.3F});
    const Result<Recording> recording = recordingOf(session);
    summary(session, recording);
    const bool typing = ImGui::GetIO().WantTextInput;
    ImGui::BeginDisabled(!recording);
    const bool goesOn = dialogButton(N_("Choose a file…"), "record:choose") ||
                        (recording && !typing && isKeyPressed(key::enter, false));
    ImGui::SameLine();
    const bool copies = dialogButton(N_("Copy command"), "record:copy");
    ImGui::EndDisabled();
    helpTip("Copies a \"texshot animate\" command that writes the same file without a window, for scripts.");
    ImGui::SameLine();
    const bool stays =
        dialogButton(N_("Cancel"), "record:cancel") || (!typing && isKeyPressed(key::escape, false));
    if (copies)
        act(session, copyCommand);
    if (goesOn || copies || stays) {
        act(session, [goesOn](Session& changed) {
            changed.asking.dialog = goesOn ? Dialog::SaveRecording : Dialog::None;
        });
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace texplorer::ui

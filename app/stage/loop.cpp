#include "app/stage/loop.h"

#include "app/stage/given_files.h"
#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/unsaved_work.h"
#include "app/ui/model/playback.h"
#include "app/ui/model/session.h"
#include "texplorer/text/printable.h"

#include <algorithm>
#include <utility>

namespace texplorer::stage {
namespace {

constexpr int settlingFrames = 3;    // frames that Dear ImGui needs after an input until the layout is final
constexpr double caretSeconds = 0.4; // the interval of drawing a blinking text cursor
constexpr double maxStep =
    0.1; // limit of the animation's step in seconds, after the window was hidden or busy
constexpr double firstFrame = 1.0 / 60; // the assumed time of the first frame in seconds

bool isSeen(const Surface& surface) {
    return surface.visible && surface.pixels.width > 0 && surface.pixels.height > 0;
}

} // namespace

Loop::Loop(Graphics& graphics, ui::Session& session, const Surface& surface, Clipboard clipboard,
           FileRequests files)
    : session_(session)
    , surface_(surface)
    , stage_(graphics, surface.scale)
    , clipboard_(std::move(clipboard))
    , files_(std::move(files))
    , settling_(settlingFrames) {
    if (!clipboard_.read || !clipboard_.write)
        return;
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* self) {
        Loop& loop = *static_cast<Loop*>(self);
        loop.pasted_ = loop.clipboard_.read();
        return loop.pasted_.c_str();
    };
    io.SetClipboardTextFn = [](void* self, const char* text) {
        // Control characters are removed: a terminal would obey them when the text is pasted.
        static_cast<Loop*>(self)->clipboard_.write(printable(text, LineBreaks::Keep));
    };
}

Loop::~Loop() = default;

void Loop::receive(const Event& event) {
    settling_ = settlingFrames;
    if (const auto* input = std::get_if<Input>(&event))
        input_.add(*input);
    else if (const auto* changed = std::get_if<SurfaceChanged>(&event))
        surface_ = changed->surface;
    else if (const auto* dropped = std::get_if<FilesDropped>(&event))
        ui::requestOpen(session_, dropped->files);
    else if (const auto* given = std::get_if<FilesGiven>(&event))
        openGivenFiles(session_, *given);
    else if (std::holds_alternative<CloseAsked>(event))
        ui::requestQuit(session_);
}

Step Loop::step(double now, const std::vector<Event>& events) {
    for (const Event& each : events)
        receive(each);
    const double seconds = std::max(0.0, now - last_.value_or(now - firstFrame));
    const bool first = !last_;
    last_ = now;
    const bool closing = std::ranges::any_of(
        events, [](const Event& event) { return std::holds_alternative<CloseAsked>(event); });
    if (!isSeen(surface_) && !closing) { // the panels answer, or ask
        ui::followEdits(session_);
        return {ui::dueAt(session_)};
    }

    if (ui::receiveFiles(session_))
        settling_ = settlingFrames;
    if (!input_.empty()) // frames follow even the last input
        settling_ = settlingFrames;
    requestFiles(session_, files_);
    if (!first)
        ui::advance(session_, std::min(seconds, maxStep));
    const ui::Requests requests =
        stage_.draw(session_, surface_, static_cast<float>(seconds), [this] { input_.feed(); });
    if (requests.fading || requests.unfinished)
        settling_ = settlingFrames;
    settling_ = std::max(0, settling_ - 1);
    return {nextWake(now), true, requests.unfinished, requests.quit, requests.title, ImGui::GetMouseCursor()};
}

std::optional<double> Loop::nextWake(double now) const {
    if (settling_ > 0 || !input_.empty() || ui::isMoving(session_))
        return now;
    std::optional<double> wake = ui::dueAt(session_);
    if (ImGui::GetIO().WantTextInput)
        wake = std::min(wake.value_or(now + caretSeconds), now + caretSeconds);
    return wake;
}

} // namespace texplorer::stage

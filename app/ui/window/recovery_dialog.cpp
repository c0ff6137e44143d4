// Unsaved work of a window that crashed.

#include "app/ui/files/scene_files.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/dialog_parts.h"
#include "texplorer/text/printable.h"

#include <array>
#include <ctime>

namespace texplorer::ui {
namespace {

/// "2026-11-02 14:05" in local time: numbers need no translation.
std::string timeText(std::filesystem::file_time_type written) {
    const auto system = std::chrono::file_clock::to_sys(written);
    const std::time_t seconds =
        std::chrono::system_clock::to_time_t(std::chrono::floor<std::chrono::seconds>(system));
    std::tm local{};
    std::array<char, 64> text{};
    if (!::localtime_r(&seconds, &local) ||
        std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local) == 0)
        return {};
    return text.data();
}

void drawPicture(const Session& session, const Pictures& pictures) {
    const float em = ImGui::GetFontSize();
    const ImVec2 size(em * 20, em * 15);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    const ImVec2 high(low.x + size.x, low.y + size.y);
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, color::ground);
    const std::shared_ptr<const Image> image = workers(session).unsaved->recovery.picture();
    if (!image)
        return;
    noteItem("restore:picture");
    drawImage(pictures, image, low, high);
}

} // namespace

void drawRestore(const Session& session, const Pictures& pictures) {
    const Recovery& recovery = workers(session).unsaved->recovery;
    if (!beginModal("Unsaved work"))
        return;
    const float em = ImGui::GetFontSize();
    const Recovery::Offer& offer = recovery.offers().front();
    const bool readable = offer.draft.has_value();
    ImGui::PushTextWrapPos(em * 22);
    if (readable) {
        const std::filesystem::path& file = offer.draft->file;
        text(file.empty() ? N_("A scene had unsaved changes when its window closed unexpectedly.")
                          : Sentence("{0} had unsaved changes when its window closed unexpectedly.",
                                     ProperName{printable(file.filename().string())}));
        noteItem("restore:name");
        if (!file.empty())
            ImGui::TextDisabled("%s", printable(file.string()).c_str());
    } else {
        text(N_("A window closed unexpectedly with unsaved changes, and their copy can't be read."));
        plainText(printable(tr(describe(offer.draft.error()))), color::problem);
        noteItem("restore:error");
    }
    ImGui::PopTextWrapPos();
    const std::size_t more = recovery.offers().size() - 1;
    const std::string time = timeText(offer.written);
    const ProperName written{time};
    dimText(more == 0 ? Sentence(written) : Sentence("{0} · {1} more after this", written, more));
    if (readable)
        drawPicture(session, pictures);
    ImGui::Dummy({0, em * 0.3F});
    std::vector<DialogAnswer> answers; // after it the dialog opens for the next one
    if (readable)
        answers.push_back({N_("Restore"), "restore:restore",
                           [](Session& s) { restoreUnsaved(s, workers(s).unsaved->recovery.restore()); },
                           key::enter});
    if (offer.place.isOpen())
        answers.push_back({N_("Discard"), "restore:discard",
                           [](Session& s) { workers(s).unsaved->recovery.discard(); }, 0,
                           N_("Deletes it permanently.")});
    answers.push_back({N_("Later"), "restore:later", [](Session& s) { workers(s).unsaved->recovery.later(); },
                       key::escape, N_("Asks again at the next start.")});
    endWithAnswers(session, answers);
}

} // namespace texplorer::ui

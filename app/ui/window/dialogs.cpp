#include "app/ui/window/dialogs.h"

#include "app/ui/files/answers.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/program_file.h"
#include "app/ui/files/recording_file.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/files/texture_file.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/dialog_parts.h"
#include "texplorer/codec/registry.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/obj_scene.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/suite/suite.h"
#include "texplorer/text/printable.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <variant>

namespace texplorer::ui {
namespace {

Result<void> chooseImage(Session& session, const std::filesystem::path& chosen,
                         const std::optional<FileFingerprint>& /*replaces*/) {
    const std::string param = std::exchange(session.asking.imageParam, {});
    if (param.empty())
        importImage(session, chosen);
    else
        chooseFile(session, param, chosen);
    return {};
}

Result<void> writeAnswers(Session& session, const std::filesystem::path& chosen,
                          const std::optional<FileFingerprint>& replaces) {
    return saveAnswers(session.settings, chosen, replaces).map([&](const std::filesystem::path& file) {
        tell(session, Sentence("Written: {0}", ProperName{file.string()}));
    });
}

/// A dialog to choose a file.
struct BrowserRow {
    Dialog dialog;
    const char* title;
    bool saving;
    bool thumbnails; ///< with thumbnails the extensions are those of images, not of scenes
    Result<void> (*answer)(Session& session, const std::filesystem::path& chosen,
                           const std::optional<FileFingerprint>& replaces);
    /// The suggested name of a file to write; nullptr: as the browser suggests for a scene.
    std::string (*name)(const Session& session) = nullptr;
};

constexpr std::array browserRows{
    BrowserRow{Dialog::OpenScene, N_("Open a scene"), false, false,
               [](Session& session, const auto& chosen, const auto&) { return openScene(session, chosen); }},
    BrowserRow{Dialog::OpenImage, N_("Open an image"), false, true, chooseImage},
    BrowserRow{Dialog::SaveScene, N_("Save the scene"), true, false, saveTo},
    BrowserRow{Dialog::SaveAnswers, N_("Save my answers"), true, false, writeAnswers,
               [](const Session&) { return std::string("answers.json"); }}, // never the scene's file
    BrowserRow{Dialog::SaveSheet, N_("Save the sheet"), true, false, saveSheet,
               [](const Session& session) { return sheetFileName(session.document); }},
    BrowserRow{Dialog::SaveProgram, N_("Export as program"), true, false, saveProgram,
               [](const Session& session) { return programFileName(session.document); }},
    BrowserRow{Dialog::SaveTexture, N_("Choose the texture's file"), true, false, saveTextureFile,
               textureFileName},
    BrowserRow{Dialog::SaveRecording, N_("Save the animation"), true, false, saveRecording,
               recordingFileName},
};

std::vector<std::string> imageExtensions() {
    std::vector<std::string> extensions;
    for (const CodecRow& row : codecRows())
        std::ranges::copy(extensionsOf(row), std::back_inserter(extensions));
    return extensions;
}

/// The files with a matching extension that "Open a scene" lists: no suites, and only pictures that hold a
/// scene. A folder may have thousands of files: only the place where texshot writes the scene is read.
bool maybeScene(const std::filesystem::path& file) {
    constexpr std::size_t firstChunks = 32;
    const std::string name = file.filename().string();
    return name.ends_with(".json") ? !name.ends_with(suite::suiteExtension)
                                   : isObjName(file) || isPictureWithScene(file, firstChunks);
}

void beginBrowsing(DialogsState& state, const Session& session, const BrowserRow& row) {
    if (std::exchange(state.browsed, row.dialog) == row.dialog)
        return;
    const Document& document = session.document;
    const bool opens = row.dialog == Dialog::OpenScene;
    const std::filesystem::path name = row.name ? row.name(session) : std::string();
    beginBrowsing(state.browser, row.title,
                  row.thumbnails ? imageExtensions()
                  : opens        ? std::vector<std::string>{".json", ".png", ".obj"}
                          : std::vector{name.empty() ? std::string(".json") : name.extension().string()},
                  row.saving, document.file.empty() ? document.suggested : document.file,
                  opens ? maybeScene : nullptr);
    state.browser.thumbnails = row.thumbnails;
    if (row.dialog == Dialog::SaveScene)
        state.browser.suffix = sceneExtension;
    if (!name.empty())
        state.browser.typed = name.string();
}

void drawDiscard(const Session& session) {
    const Document& document = session.document;
    const std::filesystem::path& file = document.file.empty() ? document.suggested : document.file;
    const std::string name = printable(file.filename().string());
    if (!beginModal(name.empty() ? "Unsaved changes in this scene"
                                 : Sentence("Unsaved changes in {0}", ProperName{name})))
        return;
    text(std::holds_alternative<pending::Quit>(session.asking.pending)
             ? N_("Save them before quitting?")
             : N_("Save them before opening another scene?"));
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    endWithAnswers(
        session, {{N_("Save"), "discard:save", save, key::enter},
                  {N_("Don't save"), "discard:drop", finishPending},
                  {N_("Cancel"), "discard:cancel", [](Session& s) { s.asking.pending = {}; }, key::escape}});
}

/// A picture by texshot is an image, too.
void drawPictureQuestion(const Session& session) {
    if (!beginModal("A picture with its scene"))
        return;
    const std::string name = printable(session.asking.picture.file.filename().string());
    text(Sentence("{0} contains the scene that it was drawn from.", ProperName{name}));
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    endWithAnswers(
        session, {{N_("Open its scene"), "picture:scene", askPictureScene, key::enter},
                  {N_("Use it as an image"), "picture:image", usePicture},
                  {N_("Cancel"), "picture:cancel", [](Session& s) { s.asking.picture = {}; }, key::escape}});
}

/// One line per file with its reason: there may be hundreds.
void drawRefused(const Session& session) {
    if (!beginModal("Files that could not be opened"))
        return;
    const float em = ImGui::GetFontSize();
    const std::size_t count = session.asking.refused.size();
    text(count == 1 ? N_("One file could not be opened. The others were opened.")
                    : Sentence("{0} files could not be opened.", count));
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(em * 46, display.x * 0.9F);
    const float height = std::min(display.y * 0.6F, em * 2.9F * static_cast<float>(count) + em);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, color::ground);
    ImGui::BeginChild("refused", {width, height}, true);
    for (const Error& each : session.asking.refused) {
        ImGui::PushTextWrapPos(0);
        plainText(printable(tr(describe(each))));
        ImGui::PopTextWrapPos();
        noteItem("refused:" + each.where.text());
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (closeButton("refused:close")) {
        closeDialog(session);
        act(session, [](Session& changed) { changed.asking.refused.clear(); });
    }
    ImGui::EndPopup();
}

constexpr std::array<std::pair<Dialog, void (*)(const Session&)>, 7> otherDialogs{
    {{Dialog::Discard, drawDiscard},
     {Dialog::FileHasChanged, drawChangedFile},
     {Dialog::Picture, drawPictureQuestion},
     {Dialog::Record, drawRecord},
     {Dialog::Texture, drawTextureDialog},
     {Dialog::Help, drawHelp},
     {Dialog::Refused, drawRefused}}};

/// Opens a dialog that the user has not requested, if no other one is open.
void openWaitingDialog(Session& session) {
    if (session.asking.dialog != Dialog::None ||
        !std::holds_alternative<std::monostate>(session.asking.pending))
        return;
    if (!session.asking.refused.empty())
        session.asking.dialog = Dialog::Refused;
    else if (const UnsavedWork* unsaved = workers(session).unsaved;
             unsaved && !unsaved->recovery.offers().empty() && session.document.loads.empty())
        session.asking.dialog = Dialog::Restore;
}

void drawBrowserDialog(const Session& session, DialogsState& state, const Pictures& pictures,
                       const BrowserRow& row) {
    beginBrowsing(state, session, row);
    std::filesystem::path chosen;
    const Browsing browsing = drawFileBrowser(session, state.browser, pictures, chosen);
    if (browsing == Browsing::Open)
        return;
    if (browsing == Browsing::Cancelled)
        return act(session, [](Session& changed) {
            changed.asking.dialog = Dialog::None;
            changed.asking.pending = {};
        });
    act(session, [&state, &row, chosen](Session& s) {
        s.asking.dialog = Dialog::None;
        s.look.notice = {};
        const Result<void> result = row.answer(s, chosen, state.browser.overwrites);
        if (!result) { // back to the list, which shows the error
            s.asking.dialog = row.dialog;
            state.browser.error = result.error().message;
            state.browser.focusName = true;
        }
    });
}

} // namespace

void drawDialogs(const Session& session, DialogsState& state, const Pictures& pictures) {
    const Dialog dialog = session.asking.dialog;
    const auto* browsed = std::ranges::find(browserRows, dialog, &BrowserRow::dialog);
    if (browsed != browserRows.end())
        drawBrowserDialog(session, state, pictures, *browsed);
    else if (dialog == Dialog::Restore)
        drawRestore(session, pictures);
    for (const auto& [each, draw] : otherDialogs) {
        if (dialog == each)
            draw(session);
    }
    if (dialog != state.browsed) // the next one starts again
        state.browsed = Dialog::None;
    act(session, openWaitingDialog); // after the answer of the last one
}

} // namespace texplorer::ui

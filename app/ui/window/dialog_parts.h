#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <string_view>
#include <vector>

namespace texplorer::ui {

/// Begins a dialog in the middle of the window, as large as its content or of this size. If it returns true,
/// call ImGui::EndPopup().
[[nodiscard]] bool beginModal(const Sentence& title, ImVec2 size = {0, 0});

/// The name of a line, before its control.
void lineName(const char* words);

/// A button of a dialog: as wide as its label, and not narrower than the others of its row.
bool dialogButton(const char* words, std::string_view name);
[[nodiscard]] float dialogButtonWidth(const char* words);

/// A button that closes a dialog with nothing to decide; Escape and Enter do the same.
bool closeButton(std::string_view name);

/// Closes the open dialog.
void closeDialog(const Session& session);

struct DialogAnswer {
    const char* words;
    const char* name; ///< in tests
    Action action;    ///< after the dialog is closed
    int key = 0;      ///< that does the same; 0: none
    const char* help = "";
    bool enabled = true;
};

/// The answers of the open dialog in a row, at its end.
void endWithAnswers(const Session& session, const std::vector<DialogAnswer>& answers);

// The dialogs that have a file of their own.
void drawChangedFile(const Session& session);   ///< Dialog::FileHasChanged
void drawHelp(const Session& session);          ///< keys, mouse and colours
void drawRecord(const Session& session);        ///< the options of an animation, before its file is chosen
void drawTextureDialog(const Session& session); ///< the same of a texture
void drawRestore(const Session& session, const Pictures& pictures); ///< there must be an offer

} // namespace texplorer::ui

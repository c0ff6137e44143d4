#pragma once

#include "app/ui/model/session.h"
#include "texplorer/files/file_fingerprint.h"
#include "texplorer/scene/params/scene_diff.h"

#include <optional>
#include <vector>

namespace texplorer::ui {

/// A scene as the text of a file.
struct SceneText {
    Scene scene{};
    std::string hash{}; ///< of the text: Document::fileHash
};
[[nodiscard]] Result<SceneText> readScene(const std::filesystem::path& path);

/// The document's file after another program has written it since it was last read or saved here.
struct ChangedFile {
    std::string hash;                 ///< of its current content, for Document::fileHash
    Result<Scene> theirs;             ///< the error: it no longer contains a scene
    std::vector<SceneChange> changes; ///< from theirs to the shown scene
};

/// The result of saving.
enum class Saving { Written, FileHasChanged };

/// Writes the scene. Image paths are relative to the scene file if they are below its folder. If another
/// program has changed the document's file, it is not written, and Document::changedFile has its content;
/// another existing file is not written either, with an error, unless it is the one that the user agreed to
/// replace, `replaces`.
[[nodiscard]] Result<Saving> saveScene(Session& session, const std::filesystem::path& path,
                                       const std::optional<FileFingerprint>& replaces = {});

/// The user's decision about Document::changedFile: the next saving may replace exactly this content …
void keepMine(Session& session);
/// … or the scene in the file replaces the current one, as an undo step.
void takeTheirs(Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "core/base/file_fingerprint.h"
#include "core/scene/params/scene_diff.h"

#include <optional>
#include <vector>

namespace texplorer::ui {

/// A scene as a file has it.
struct SceneText {
    Scene scene{};
    std::string hash{}; ///< of the text: Document::fileHash
};
[[nodiscard]] Result<SceneText> readScene(const std::filesystem::path& path);

/// The document's file, which another program has written since it was read or saved here.
struct ChangedFile {
    std::string hash;                 ///< of what it has now, for Document::fileHash
    Result<Scene> theirs;             ///< the error: it holds no scene now
    std::vector<SceneChange> changes; ///< from theirs to what is shown
};

/// What came of saving.
enum class Saving { Written, FileHasChanged };

/// Writes the scene. Image paths are kept relative to the scene file where they lie below its folder. A file
/// of the document's that another program has changed stays, and Document::changedFile says what it has; so
/// does, with an error, another one that isn't what the user has agreed to replace, `replaces`.
[[nodiscard]] Result<Saving> saveScene(Session& session, const std::filesystem::path& path,
                                       const std::optional<FileFingerprint>& replaces = {});

/// What the user decides about Document::changedFile: the next saving may replace just this content …
void keepMine(Session& session);
/// … or the scene becomes what the file has, a step of undo.
void takeTheirs(Session& session);

} // namespace texplorer::ui

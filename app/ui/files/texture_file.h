#pragma once

#include "app/ui/model/session.h"
#include "texplorer/texture/saved_texture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Why the texture of the selected unit can't be saved in any way; empty: it can.
[[nodiscard]] Sentence textureRefusal(const Session& session);

/// The extents of the levels that the file will have, as chosen by Session::saving. Errors: textureRefusal,
/// and those of checkSaving.
[[nodiscard]] Result<std::vector<PlannedLevel>> savedLevels(const Session& session);

/// Its levels, saved or not.
[[nodiscard]] LevelPlan levelsToSave(const Session& session);

/// The order for its file; of the light's depth map, as it is at the present time. Errors: those of
/// savedLevels.
[[nodiscard]] Result<FileOrder> textureOrder(const Session& session, std::filesystem::path file);

/// "earth.dds"; never the name of its image.
[[nodiscard]] std::string textureFileName(const Session& session);

/// Writes it. Errors: those of textureOrder, and a name that is not valid for the format.
[[nodiscard]] Result<void> saveTextureFile(Session& session, const std::filesystem::path& file,
                                           const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui

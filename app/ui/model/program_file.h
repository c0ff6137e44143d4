#pragma once

#include "app/ui/model/session.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace texplorer::ui {

/// What a program of the scene would be called: "scene.c".
[[nodiscard]] std::string programFileName(const Document& document, emit::Flavour flavour);

/// Writes the scene as a program of WindowState::flavour. Errors: what the flavour can't say, what can't be
/// written.
[[nodiscard]] Result<void> saveProgram(const Session& session, const std::filesystem::path& file);

} // namespace texplorer::ui

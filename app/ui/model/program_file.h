#pragma once

#include "app/ui/model/session.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace texplorer::ui {

/// What a program of the scene would be called: "scene.c".
[[nodiscard]] std::string programFileName(const Document& document, emit::Flavour flavour);

/// The scene as a program of WindowState::flavour.
[[nodiscard]] FileOrder programOrder(const Session& session, std::filesystem::path file);

/// Has it written. Errors: a name that isn't a program's.
[[nodiscard]] Result<void> saveProgram(Session& session, const std::filesystem::path& file);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "texplorer/base/result.h"
#include "texplorer/emit/program_worker.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The file name of the scene's program: "scene.c".
[[nodiscard]] std::string programFileName(const Document& document);

/// The scene's program, to display; nothing: its texels are still being made in the background.
[[nodiscard]] std::optional<emit::ProgramWorker::Program> programNow(Session& session, emit::Flavour flavour);

/// The scene as a program of Asking::flavour.
[[nodiscard]] FileOrder programOrder(const Session& session, std::filesystem::path file);

/// Asks for the file of a program; if it is already known that none is possible, reports the reason instead.
void askSaveProgram(Session& session, emit::Flavour flavour);

/// Writes it. Errors: a name that is not valid for a program.
[[nodiscard]] Result<void> saveProgram(Session& session, const std::filesystem::path& file,
                                       const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui

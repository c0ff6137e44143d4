#pragma once

#include "app/ui/model/session.h"
#include "core/base/result.h"
#include "core/emit/program_worker.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

/// What a program of the scene would be called: "scene.c".
[[nodiscard]] std::string programFileName(const Document& document, emit::Flavour flavour);

/// The scene without what the present time makes of it, where that is something: a program has all key
/// frames.
[[nodiscard]] std::optional<Scene> withoutTime(const Document& document);

/// The scene's program, to look at; nothing: its texels are being made beside the window.
[[nodiscard]] std::optional<emit::ProgramWorker::Program> programNow(const Session& session,
                                                                     emit::Flavour flavour);

/// The scene as a program of WindowState::flavour.
[[nodiscard]] FileOrder programOrder(const Session& session, std::filesystem::path file);

/// Asks for the file of a program; where it is known at once that there can be none, it is said instead.
void askSaveProgram(Session& session, emit::Flavour flavour);

/// Has it written. Errors: a name that isn't a program's.
[[nodiscard]] Result<void> saveProgram(Session& session, const std::filesystem::path& file,
                                       const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui

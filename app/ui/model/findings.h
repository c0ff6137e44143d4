#pragma once

#include "app/ui/model/session.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

// The findings of the diagnosis for the panels.

/// Updates session.document.findings; cheap if nothing has changed.
void diagnoseSession(Session& session, const DriverFacts& driver);

/// Whether a parameter belongs to a choice that is not selected, so that it is not shown.
[[nodiscard]] bool isUnused(const Session& session, std::string_view path);

/// The sentence of a finding or note in the window's language, with a capital and a full stop: "The texture
/// is incomplete: …."
[[nodiscard]] Sentence shownSentence(const Sentence& problem);

/// Whether the parameter is edited in the list of vertices, with their coordinates.
[[nodiscard]] bool isOfCoords(std::string_view path);

/// Selects the object of a parameter, opens its section and scrolls to it in the next frame.
void reveal(Session& session, const std::string& path);

/// The assignments of a fix, one per line.
[[nodiscard]] Sentence assignmentsOf(const Fix& fix);

/// Applies a fix as one undo step.
void applyFix(const Session& session, const Fix& fix);

} // namespace texplorer::ui

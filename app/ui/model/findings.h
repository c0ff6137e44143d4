#pragma once

#include "app/ui/model/session.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

// What the diagnosis says, as the panels ask for it.

/// Brings session.document.findings up to date; costs little where nothing has changed.
void diagnoseSession(Session& session, const DriverFacts& driver);

/// Whether a parameter belongs to a choice that isn't made, so that it isn't shown.
[[nodiscard]] bool isUnused(const Session& session, std::string_view path);

/// A finding as a sentence for a reader: "The texture is incomplete: … ."
[[nodiscard]] std::string sentenceOf(const Finding& finding);

/// Selects what a parameter is part of, opens its section and scrolls to it with the next frame.
void reveal(Session& session, const std::string& path);

/// What it sets, a line each.
[[nodiscard]] std::string assignmentsOf(const Fix& fix);

/// One step of undo.
void applyFix(Session& session, const Fix& fix);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"

#include <filesystem>
#include <string>

namespace texplorer::ui {

/// Shows an error to the user. If the content of `file` was the reason, it offers to inspect the file.
void say(Session& session, const Error& error, const std::filesystem::path& file = {});
void say(Session& session, Sentence sentence);
/// Shows a message about a success that is not visible otherwise.
void tell(Session& session, Sentence sentence);
/// Shows an error to the user.
void report(Session& session, const Result<void>& result, const std::filesystem::path& file = {});

} // namespace texplorer::ui

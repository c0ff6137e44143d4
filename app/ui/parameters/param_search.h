#pragma once

#include "app/ui/model/session.h"

#include <string_view>

namespace texplorer::ui {

/// Draws every parameter that matches the search, with its tab and its control: first those with a matching
/// name.
void searchResults(const Session& session, std::string_view words);

} // namespace texplorer::ui

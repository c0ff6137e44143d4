#pragma once

#include "app/ui/model/session.h"

#include <string_view>

namespace texplorer::ui {

/// Every parameter that is looked for, with its tab and as one edits it there: first those with such a name.
void searchResults(Session& session, std::string_view words);

} // namespace texplorer::ui

#pragma once

#include "app/ui/language/catalogue.h"
#include "app/ui/state/document.h"

namespace texplorer::ui {

/// The names of a document's files and models, which are not translated.
[[nodiscard]] Names namesIn(const Document& document);

} // namespace texplorer::ui

#pragma once

#include "app/ui/language/catalogue.h"
#include "app/ui/model/document.h"

namespace texplorer::ui {

/// What a document's files and models are called: nobody's to translate.
[[nodiscard]] Names namesIn(const Document& document);

} // namespace texplorer::ui

#include "app/ui/figures/sheet.h"

namespace texplorer::ui {

void drawSheet(Session& /*session*/, SheetState& /*state*/, const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

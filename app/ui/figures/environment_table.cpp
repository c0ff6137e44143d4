#include "app/ui/figures/environment_table.h"

namespace texplorer::ui {

void drawEnvironmentTable(Session& /*session*/, EnvironmentTableState& /*state*/,
                          const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

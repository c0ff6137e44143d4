#include "app/ui/figures/edge_lens.h"

namespace texplorer::ui {

void drawEdgeLens(Session& /*session*/, EdgeLensState& /*state*/, const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

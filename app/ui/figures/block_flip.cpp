#include "app/ui/figures/block_flip.h"

namespace texplorer::ui {

void drawBlockFlip(Session& /*session*/, BlockFlipState& /*state*/, const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

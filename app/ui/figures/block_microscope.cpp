#include "app/ui/figures/block_microscope.h"

namespace texplorer::ui {

void drawBlockMicroscope(Session& /*session*/, BlockMicroscopeState& /*state*/,
                         const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

#include "app/ui/figures/emboss_theory.h"

namespace texplorer::ui {

void drawEmbossTheory(Session& /*session*/, EmbossTheoryState& /*state*/, const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

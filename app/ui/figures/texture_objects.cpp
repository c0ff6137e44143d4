#include "app/ui/figures/texture_objects.h"

namespace texplorer::ui {

void drawTextureObjects(Session& /*session*/, TextureObjectsState& /*state*/, const Pictures& /*pictures*/) {}

} // namespace texplorer::ui

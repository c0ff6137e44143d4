#pragma once

#include "app/ui/model/commands.h"

namespace texplorer::ui {

/// Completes the block of a texture's calls, "textures[0]": one glTexImage for each level that is given one
/// by one, and around them glPixelTransferf where scaling is the last thing that is done to its image.
void addImageCommands(const Scene& scene, std::size_t texture, std::vector<Command>& block);

} // namespace texplorer::ui

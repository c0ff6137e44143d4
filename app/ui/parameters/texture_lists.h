#pragma once

// The lists of a texture: the steps of its preparation, each with its resulting picture, and its individual
// levels, each with its picture and size.

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "texplorer/scene/params/params.h"

#include <string>

namespace texplorer::ui {

/// For a texture of the scene. `summary` has the pictures made so far; nullptr: none yet.
void preparationList(const Session& session, std::size_t texture, const LevelsSummary* summary,
                     const Pictures& pictures);
void levelList(const Session& session, std::size_t texture, const LevelsSummary* summary,
               const Pictures& pictures);

/// Whether a value may be set at once. A source without a file asks for one; a file that is not loaded is
/// read first. `owner` is the path of the object that names it, `file` its current name.
[[nodiscard]] bool acceptsFile(const Session& session, const std::string& owner, const std::string& file,
                               const ParamRow& row, const Value& value);

} // namespace texplorer::ui

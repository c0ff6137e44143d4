#pragma once

// What a texture has a list of: the steps of its preparation, each with the picture that it makes, and the
// levels that are given one by one, each with its picture and size.

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "core/scene/params/params.h"

#include <string>

namespace texplorer::ui {

/// Of a texture of the scene. `summary` has the pictures, as far as they are made; nullptr: not yet.
void preparationList(Session& session, std::size_t texture, const LevelsSummary* summary,
                     const Pictures& pictures);
void levelList(Session& session, std::size_t texture, const LevelsSummary* summary, const Pictures& pictures);

/// Whether a value may be written at once. A source that has no file yet asks for one; a file that isn't
/// loaded is read first. `owner` is the path of what names it, `file` what it names now.
[[nodiscard]] bool acceptsFile(Session& session, const std::string& owner, const std::string& file,
                               const ParamRow& row, const Value& value);

} // namespace texplorer::ui

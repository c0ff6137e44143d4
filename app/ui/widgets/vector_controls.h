#pragma once

#include "app/ui/model/session.h"
#include "core/scene/params/params.h"

#include <glm/glm.hpp>

#include <string>

namespace texplorer::ui {

// Controls of what has several numbers, in the current item width; `path` is what tests call them. Each is
// true where `value` changed.

/// A number for each component, with its letter: x, y, z, w.
bool vectorControl(Session& session, const ParamRow& row, glm::vec3& value, const std::string& path);
bool vectorControl(Session& session, const ParamRow& row, glm::vec4& value, const std::string& path);

/// Row by row as one writes a matrix down, though OpenGL keeps it column by column. A row has the letter of
/// the coordinate that it makes.
bool matrixControl(Session& session, const ParamRow& row, glm::mat4& value, const std::string& path);

/// A swatch; pressed, it opens colorPopup, which is apart from it so that the swatch stays the "last item" of
/// the line.
bool colorControl(glm::vec4& value);
bool colorPopup(Session& session, glm::vec4& value, const std::string& path);

} // namespace texplorer::ui

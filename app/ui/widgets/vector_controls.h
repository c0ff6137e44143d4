#pragma once

#include "app/ui/model/session.h"
#include "texplorer/scene/params/params.h"

#include <glm/glm.hpp>

#include <span>
#include <string>

namespace texplorer::ui {

// Controls for values with several numbers, in the current item width; `path` is the name in tests. Each
// returns true if `value` changed.

/// A number for each component, with its letter: x, y, z, w.
bool vectorControl(const Session& session, const ParamRow& row, std::span<float> numbers,
                   const std::string& path);

/// Rows as in written mathematics, although OpenGL stores columns. A row has the letter of the coordinate
/// that it computes.
bool matrixControl(const Session& session, const ParamRow& row, glm::mat4& value, const std::string& path);

/// A swatch that opens colorPopup when pressed; the popup is separate so that the swatch stays the "last
/// item" of the line.
bool colorControl(glm::vec4& value);
bool colorPopup(const Session& session, glm::vec4& value, const std::string& path);

} // namespace texplorer::ui

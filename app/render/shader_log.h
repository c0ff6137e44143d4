#pragma once

#include "app/view/pass_shader.h"

#include <optional>
#include <string_view>
#include <vector>

namespace texplorer::render {

/// A driver's compile log with the files' names and lines in the place of the source's: "lighting.glsl:12:
/// 'eyeNorml' undeclared". A line that names no place stays as it is.
[[nodiscard]] std::vector<view::ShaderMessage>
translateLog(std::string_view log, const glsl::StageSource& source,
             std::optional<view::ShaderStage> stage = std::nullopt);

} // namespace texplorer::render

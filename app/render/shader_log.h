#pragma once

#include "app/view/pass_shader.h"

#include <optional>
#include <string_view>
#include <vector>

namespace texplorer::render {

/// Replaces positions in a driver's compile log by names and lines of files: "lighting.glsl:12: 'eyeNorml'
/// undeclared". A line without a position stays unchanged.
[[nodiscard]] std::vector<view::ShaderMessage>
translateLog(std::string_view log, const glsl::StageSource& source,
             std::optional<view::ShaderStage> stage = std::nullopt);

} // namespace texplorer::render

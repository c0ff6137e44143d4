#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// The installed path of the schema: the "$schema" of scenes that Texplorer writes, and the schema's own
/// "$id".
inline constexpr std::string_view sceneSchemaId = "file:///usr/share/texplorer/scene.schema.json";

/// Makes a JSON Schema (draft 2020-12) of scene files from the parameters' rows: labels, help and GL calls,
/// ranges, enumerants, initial values, lengths. It accepts what parseScene accepts, and refuses everything
/// else except what a schema cannot express: repeated keys, texts of too many bytes, and members that do not
/// fit each other (texplorer/scene/params/scene_check.h). Ends with a line feed.
[[nodiscard]] std::string sceneSchema();

} // namespace texplorer

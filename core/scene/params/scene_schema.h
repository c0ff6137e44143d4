#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// Where Texplorer's package puts the schema: what a scene that Texplorer writes names as its "$schema", and
/// the schema's own "$id".
inline constexpr std::string_view sceneSchemaId = "file:///usr/share/texplorer/scene.schema.json";

/// A JSON Schema (draft 2020-12) of scene files, made of the parameters' rows: labels, help and GL calls,
/// ranges, enumerants, initial values, lengths. It accepts what parseScene accepts, and refuses the rest but
/// for what a schema can't say: keys that are repeated, texts of too many bytes, and how members fit each
/// other (core/scene/params/scene_check.h). Ends with a line feed.
[[nodiscard]] std::string sceneSchema();

} // namespace texplorer

#pragma once

// The keys of parameters, looked up in their rows by member, so that each key is written only in its row.

#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer {

// The keys of a scene file that are not parameters.
inline constexpr std::string_view versionKey = "version";
inline constexpr std::string_view schemaKey = "$schema"; ///< for editors that validate files

/// The key in the row of a member. For a member with several rows (Model::texCoords), `element` is the index
/// among them.
[[nodiscard]] std::string_view findKey(MemberId member, std::size_t element = 0);

/// keyOf<&Texture::minFilter>() is "minFilter", keyOf<&Scene::light>() is "light".
template<auto Member>
[[nodiscard]] const std::string& keyOf() {
    static const std::string key(findKey(memberId<Member>));
    return key;
}

/// For tables of keys, which are evaluated at run time.
using Key = const std::string& (*)();

/// pathOf<&Scene::light, &Light::ambient>() is "light.ambient".
template<auto First, auto... Rest>
[[nodiscard]] const std::string& pathOf() {
    static const std::string path = (keyOf<First>() + ... + ("." + keyOf<Rest>()));
    return path;
}

/// elementOf<&Scene::textures>(3) is "textures[3]".
template<auto Member>
[[nodiscard]] std::string elementOf(std::size_t index) {
    return fmt::format("{}[{}]", keyOf<Member>(), index);
}

} // namespace texplorer

#pragma once

// The keys of the parameters, taken from their rows by the members: a key is typed in its row and nowhere
// else.

#include "core/scene/params/params.h"

#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer {

// The keys of a scene file that are no parameters.
inline constexpr std::string_view versionKey = "version";
inline constexpr std::string_view schemaKey = "$schema"; ///< for editors that check while one types

/// The key in the row of a member. A member with several rows (Model::texCoords) has `element` of them before
/// it.
[[nodiscard]] std::string_view findKey(MemberId member, std::size_t element = 0);

/// keyOf<&Texture::minFilter>() is "minFilter", keyOf<&Scene::light>() is "light".
template<auto Member>
[[nodiscard]] const std::string& keyOf() {
    static const std::string key(findKey(memberId<Member>));
    return key;
}

/// For tables of keys, which are known when a program runs.
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

#pragma once

// Names, texture objects and texture units as a value, to show what each of a dozen calls changes. OpenGL
// 2.1, sections 3.8.12 (texture objects) and 3.8.13 (environments), for GL_TEXTURE_2D only.

#include "texplorer/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace texplorer::objects {

using Name = std::uint32_t;

inline constexpr std::size_t unitCount = 2;

/// The state that glBindTexture switches.
struct TextureObject {
    Texture state{};            ///< of glTexParameter, with GL's initial values
    std::optional<int> picture; ///< the picture of glTexImage2D; empty: no image

    bool operator==(const TextureObject&) const = default;
};

/// The state that does not depend on the bound texture.
struct UnitState {
    Name bound = 0;
    bool enabled = false; ///< GL_TEXTURE_2D
    EnvMode envMode = EnvMode::Modulate;

    bool operator==(const UnitState&) const = default;
};

/// The names, objects and units of a context.
struct TextureNames {
    /// Empty: glGenTextures has returned the name, but it was never bound, so it has no object. Name 0 is the
    /// default object; it cannot be deleted, and glIsTexture returns false for it.
    std::map<Name, std::optional<TextureObject>> names{{0, TextureObject{}}};
    std::array<UnitState, unitCount> units{};
    std::size_t active = 0; ///< the unit of glBindTexture, glEnable and glTexEnv

    bool operator==(const TextureNames&) const = default;

    [[nodiscard]] const UnitState& activeUnit() const { return units.at(active); }
    [[nodiscard]] UnitState& activeUnit() { return units.at(active); }
    /// The object bound to a unit.
    [[nodiscard]] const TextureObject& objectOf(std::size_t unit) const {
        return *names.at(units.at(unit).bound);
    }
};

/// The effect of a unit on a fragment.
enum class Sampled : std::uint8_t {
    Off,       ///< GL_TEXTURE_2D is disabled
    NoImage,   ///< the object has no image: incomplete, as if disabled
    NoMipmaps, ///< the minification filter needs missing levels: incomplete, as if disabled
    Textured,
};
[[nodiscard]] Sampled sampledBy(const TextureNames& names, std::size_t unit);

/// The colour of a fragment after a unit with the filtered colour `texel`; all images are RGB.
[[nodiscard]] glm::vec4 colorAfter(const TextureNames& names, std::size_t unit, glm::vec4 before,
                                   glm::vec4 texel);

} // namespace texplorer::objects

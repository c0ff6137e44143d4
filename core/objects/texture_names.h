#pragma once

// Names, texture objects and texture units as a value: what each of a dozen calls changes, and what it leaves
// alone. OpenGL 2.1, sections 3.8.12 (texture objects) and 3.8.13 (environments), for GL_TEXTURE_2D alone.

#include "core/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace texplorer::objects {

using Name = std::uint32_t;

inline constexpr std::size_t unitCount = 2;

/// What glBindTexture brings back: all of it, and nothing else.
struct TextureObject {
    Texture state{};            ///< glTexParameter's, with GL's initial values
    std::optional<int> picture; ///< which one glTexImage2D has given it; none: no image

    bool operator==(const TextureObject&) const = default;
};

/// What stays whatever is bound.
struct UnitState {
    Name bound = 0;
    bool enabled = false; ///< GL_TEXTURE_2D
    EnvMode envMode = EnvMode::Modulate;

    bool operator==(const UnitState&) const = default;
};

/// A context's names, objects and units.
struct TextureNames {
    /// Nothing: glGenTextures has given the name away, and nobody has bound it yet, so there is no object.
    /// Name 0 is the object that is there from the start; it can't be deleted, and glIsTexture denies it.
    std::map<Name, std::optional<TextureObject>> names{{0, TextureObject{}}};
    std::array<UnitState, unitCount> units{};
    std::size_t active = 0; ///< the unit that glBindTexture, glEnable and glTexEnv mean

    bool operator==(const TextureNames&) const = default;

    [[nodiscard]] const UnitState& activeUnit() const { return units.at(active); }
    [[nodiscard]] UnitState& activeUnit() { return units.at(active); }
    /// What is bound to a unit.
    [[nodiscard]] const TextureObject& objectOf(std::size_t unit) const {
        return *names.at(units.at(unit).bound);
    }
};

/// What a unit does with a fragment.
enum class Sampled : std::uint8_t {
    Off,       ///< GL_TEXTURE_2D isn't enabled
    NoImage,   ///< the object has none: incomplete, as if off
    NoMipmaps, ///< its minification filter wants levels that it hasn't: incomplete, as if off
    Textured,
};
[[nodiscard]] Sampled sampledBy(const TextureNames& names, std::size_t unit);

/// The colour of a fragment after a unit, `texel` being what its texture has there: RGB images.
[[nodiscard]] glm::vec4 colorAfter(const TextureNames& names, std::size_t unit, glm::vec4 before,
                                   glm::vec4 texel);

} // namespace texplorer::objects

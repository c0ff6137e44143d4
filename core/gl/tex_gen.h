#pragma once

// Generated texture coordinates: OpenGL 2.1, section 2.11.4.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class TexGenMode : std::uint32_t {
    EyeLinear = 0x2400,
    ObjectLinear = 0x2401,
    SphereMap = 0x2402,
    NormalMap = 0x8511,
    ReflectionMap = 0x8512,
};

/// In this order, the modes of each coordinate are the first ones: q has two, r four, s and t all five.
inline constexpr std::array texGenModeRows{
    row(TexGenMode::EyeLinear, "GL_EYE_LINEAR", "Eye linear",
        "The distance of the vertex from a plane that is fixed to the camera, so models slide through the "
        "texture. GL's initial value.",
        "1.0"),
    row(TexGenMode::ObjectLinear, "GL_OBJECT_LINEAR", "Object linear",
        "The distance of the vertex from a plane that is fixed to the model, so the texture sticks to it.",
        "1.0"),
    row(TexGenMode::ReflectionMap, "GL_REFLECTION_MAP", "Reflection map",
        "The direction of the eye's reflection at the vertex, as a vector for a cube map.", "1.3"),
    row(TexGenMode::NormalMap, "GL_NORMAL_MAP", "Normal map",
        "The vertex's normal in eye coordinates, as a vector for a cube map.", "1.3"),
    row(TexGenMode::SphereMap, "GL_SPHERE_MAP", "Sphere map",
        "The place of the reflected direction in the photograph of a mirror ball. Looks like polished "
        "metal.",
        "1.0"),
};

template<>
struct EnumTable<TexGenMode> {
    static constexpr std::span<const EnumRow> rows = texGenModeRows;
};

inline constexpr auto texGenModesOfQ = std::span<const EnumRow>(texGenModeRows).first<2>();
inline constexpr auto texGenModesOfR = std::span<const EnumRow>(texGenModeRows).first<4>();

static_assert(texGenModeRows.size() == 5);

} // namespace texplorer

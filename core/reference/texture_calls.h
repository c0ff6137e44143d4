#pragma once

#include "texplorer/reference/texture_names.h"
#include "texplorer/scene/params/params.h"

#include <string>
#include <variant>

namespace texplorer::objects {

// The calls. Each uses GL_TEXTURE_2D of the active unit.

struct GenTexture {
    bool operator==(const GenTexture&) const = default;
};
struct BindTexture {
    Name name = 0;
    bool operator==(const BindTexture&) const = default;
};
struct DeleteTexture {
    Name name = 0;
    bool operator==(const DeleteTexture&) const = default;
};
struct IsTexture {
    Name name = 0;
    bool operator==(const IsTexture&) const = default;
};
struct ActiveTexture {
    std::size_t unit = 0;
    bool operator==(const ActiveTexture&) const = default;
};
struct EnableTexture {
    bool on = true;
    bool operator==(const EnableTexture&) const = default;
};
struct SetEnvMode {
    EnvMode mode = EnvMode::Modulate;
    bool operator==(const SetEnvMode&) const = default;
};
/// glTexParameter: a row of textureTable with its value.
struct SetParameter {
    const ParamRow* row = nullptr;
    Value value;
    bool operator==(const SetParameter&) const = default;
};
/// glTexImage2D, of level 0.
struct GiveImage {
    int picture = 0;
    bool operator==(const GiveImage&) const = default;
};

using Call = std::variant<GenTexture, BindTexture, DeleteTexture, IsTexture, ActiveTexture, EnableTexture,
                          SetEnvMode, SetParameter, GiveImage>;

[[nodiscard]] SetParameter setParameter(MinFilter filter);
[[nodiscard]] SetParameter setParameter(MagFilter filter);
[[nodiscard]] SetParameter setWrapS(Wrap wrap);
[[nodiscard]] SetParameter setWrapT(Wrap wrap);

/// The result of a call.
struct Answer {
    std::optional<Name> name;      ///< of glGenTextures
    std::optional<bool> isTexture; ///< of glIsTexture

    bool operator==(const Answer&) const = default;
};

/// Executes a call like OpenGL. Calls that OpenGL would refuse cannot be expressed; calls without effect can:
/// deleting 0 or an unused name. A name that glGenTextures did not return can be bound, as OpenGL 2.1 allows.
Answer apply(TextureNames& names, const Call& call);

/// The call in C, with its result as a comment: "glBindTexture(GL_TEXTURE_2D, 1);", "// 1".
[[nodiscard]] std::string codeOf(const Call& call, const Answer& answer = {});

} // namespace texplorer::objects

#include "texplorer/reference/texture_calls.h"

#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <cassert>

namespace texplorer::objects {
namespace {

constexpr Target target = Target::Texture2D;

/// An object that wasn't there is there now, with GL's initial values.
Answer made(TextureNames& names, const BindTexture& call) {
    std::optional<TextureObject>& object = names.names[call.name];
    if (!object)
        object.emplace();
    names.activeUnit().bound = call.name;
    return {};
}

Answer made(TextureNames& names, const GenTexture& /*call*/) {
    Name name = 1;
    while (names.names.contains(name))
        ++name;
    names.names[name] = std::nullopt;
    return {.name = name, .isTexture = {}};
}

/// It is as though glBindTexture with 0 had been executed wherever the object was bound.
Answer made(TextureNames& names, const DeleteTexture& call) {
    if (call.name == 0)
        return {};
    for (UnitState& unit : names.units) {
        if (unit.bound == call.name)
            unit.bound = 0;
    }
    names.names.erase(call.name);
    return {};
}

Answer made(TextureNames& names, const IsTexture& call) {
    const auto found = names.names.find(call.name);
    return {.name = {}, .isTexture = call.name != 0 && found != names.names.end() && found->second};
}

Answer made(TextureNames& names, const ActiveTexture& call) {
    assert(call.unit < unitCount);
    names.active = call.unit;
    return {};
}

Answer made(TextureNames& names, const EnableTexture& call) {
    names.activeUnit().enabled = call.on;
    return {};
}

Answer made(TextureNames& names, const SetEnvMode& call) {
    names.activeUnit().envMode = call.mode;
    return {};
}

TextureObject& boundObject(TextureNames& names) {
    return *names.names.at(names.activeUnit().bound);
}

Answer made(TextureNames& names, const SetParameter& call) {
    call.row->write(&boundObject(names).state, call.value);
    return {};
}

Answer made(TextureNames& names, const GiveImage& call) {
    boundObject(names).picture = call.picture;
    return {};
}

template<auto Member, class Enum>
SetParameter parameterOf(Enum value) {
    const ParamRow* row = findParam(textureTable(), keyOf<Member>());
    assert(row);
    return {row, EnumValue{static_cast<std::uint32_t>(value)}};
}

std::string written(const GenTexture& /*call*/) {
    return "glGenTextures(1, &name);";
}
std::string written(const BindTexture& call) {
    return fmt::format("glBindTexture({}, {});", rowOf(target).name, call.name);
}
std::string written(const DeleteTexture& call) {
    return fmt::format("glDeleteTextures(1, &name{});", call.name);
}
std::string written(const IsTexture& call) {
    return fmt::format("glIsTexture({});", call.name);
}
std::string written(const ActiveTexture& call) {
    return fmt::format("glActiveTexture({});", textureUnitName(call.unit));
}
std::string written(const EnableTexture& call) {
    return fmt::format("{}({});", call.on ? "glEnable" : "glDisable", rowOf(target).name);
}
std::string written(const SetEnvMode& call) {
    const ParamRow* row = findParam(unitTable(), keyOf<&Unit::envMode>());
    return formatCall(*row, EnumValue{static_cast<std::uint32_t>(call.mode)}, target) + ";";
}
std::string written(const SetParameter& call) {
    return formatCall(*call.row, call.value, target) + ";";
}
std::string written(const GiveImage& call) {
    return fmt::format("glTexImage2D({}, 0, {}, 64, 64, 0, {}, {}, image{});", rowOf(target).name,
                       rowOf(BaseFormat::Rgb).name, rowOf(BaseFormat::Rgb).name, unsignedByteType,
                       call.picture);
}

} // namespace

SetParameter setParameter(MinFilter filter) {
    return parameterOf<&Texture::minFilter>(filter);
}
SetParameter setParameter(MagFilter filter) {
    return parameterOf<&Texture::magFilter>(filter);
}
SetParameter setWrapS(Wrap wrap) {
    return parameterOf<&Texture::wrapS>(wrap);
}
SetParameter setWrapT(Wrap wrap) {
    return parameterOf<&Texture::wrapT>(wrap);
}

Answer apply(TextureNames& names, const Call& call) {
    return std::visit([&](const auto& each) { return made(names, each); }, call);
}

std::string codeOf(const Call& call, const Answer& answer) {
    std::string code = std::visit([](const auto& each) { return written(each); }, call);
    if (answer.name)
        code += fmt::format("  // {}", *answer.name);
    if (answer.isTexture)
        code += fmt::format("  // {}", booleanName(*answer.isTexture));
    return code;
}

} // namespace texplorer::objects

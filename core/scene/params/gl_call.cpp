// A row's GL call as a program has it: for a texture's target, with the value in its place.

#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer {
namespace {

/// What stands in a call for "{n}", "{extents}" and "{image}": to what an image is uploaded.
struct TargetWords {
    Target target;
    std::string_view n;
    std::string_view extents;
    std::string_view image = "{target}";
};
constexpr std::array targetWords{
    TargetWords{Target::Texture1D, "1", "width"},
    TargetWords{Target::Texture2D, "2", N_("width, height")},
    TargetWords{Target::Texture3D, "3", N_("width, height, depth")},
    TargetWords{Target::CubeMap, "2", N_("width, height"), N_("{first face} + face")},
};
static_assert(targetWords.size() == EnumTable<Target>::rows.size());

void replaceAll(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/// glLightfv takes a pointer to its numbers, glColor4f takes them one by one.
bool takesPointer(std::string_view call) {
    return call.substr(0, call.find('(')).ends_with('v');
}

template<class Vector>
std::string numbersOf(const Vector& vector, bool negates, bool pointer) {
    const Vector given = negates ? Vector(0) - vector : vector; // not -vector: 0 has no sign
    const std::string numbers = formatNumbers({&given.x, static_cast<std::size_t>(Vector::length())}, ", ");
    return pointer ? fmt::format("{{{}}}", numbers) : numbers;
}

std::string argumentOf(const ParamRow& row, const Value& value, bool negates) {
    switch (row.kind) {
    case Kind::Bool:
        return std::string(booleanName(std::get<bool>(value)));
    case Kind::Float:
        return formatNumber(negates ? 0 - std::get<float>(value) : std::get<float>(value));
    case Kind::Vec3:
        return numbersOf(std::get<glm::vec3>(value), negates, takesPointer(row.glCall));
    case Kind::Vec4:
    case Kind::Color:
        return numbersOf(std::get<glm::vec4>(value), negates, takesPointer(row.glCall));
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
    case Kind::IndexList:
        return std::string(row.key); // called once a vertex
    case Kind::Matrix:
    case Kind::Int:
    case Kind::Enum:
    case Kind::Text:
        return formatValue(row, value);
    }
    return {};
}

} // namespace

std::string callFor(const ParamRow& row, Target target) {
    std::string call(row.glCall);
    const auto words = std::ranges::find(targetWords, target, &TargetWords::target);
    if (words == targetWords.end())
        return call;
    replaceAll(call, "{n}", words->n);
    replaceAll(call, "{extents}", words->extents);
    replaceAll(call, "{image}", words->image);
    replaceAll(call, "{target}", rowOf(target).name);
    replaceAll(call, "{first face}", rowOf(CubeFace::PositiveX).name);
    return call;
}

std::string_view glNameOf(const ParamRow& row) {
    const std::string_view call = row.glCall;
    const std::string_view before = call.substr(0, std::min(call.size(), call.find("{}")));
    // The last name before the value: the others say what of.
    if (const std::size_t at = before.rfind("GL_"); at != std::string_view::npos)
        return before.substr(at, before.find_first_of(",)", at) - at);
    constexpr std::string_view alone = "({})";
    const bool named = call.ends_with(alone) && !call.starts_with("glEnable");
    return named ? call.substr(0, call.size() - alone.size()) : std::string_view{};
}

std::string formatCall(const ParamRow& row, const Value& value, Target target) {
    constexpr std::string_view place = "{}";
    constexpr std::string_view negated = "-{}"; // of every component, and without a second sign
    constexpr std::string_view enable = "glEnable";
    std::string call = callFor(row, target);
    if (row.kind == Kind::Bool && call.find(place) == std::string::npos) {
        if (!std::get<bool>(value) && call.starts_with(enable))
            call.replace(0, enable.size(), "glDisable");
        return call;
    }
    const bool negates = call.find(negated) != std::string::npos;
    replaceAll(call, negates ? negated : place, argumentOf(row, value, negates));
    return call;
}

} // namespace texplorer

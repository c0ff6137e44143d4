#include "texplorer/scene/params/value_mix.h"

#include <algorithm>
#include <cmath>

namespace texplorer {
namespace {

double between(double from, double to, double share) {
    const double mix = from * (1 - share) + to * share;
    return std::clamp(mix, std::min(from, to), std::max(from, to));
}

float blend(float from, float to, double share) {
    return static_cast<float>(between(double{from}, double{to}, share));
}

int blend(int from, int to, double share) {
    return static_cast<int>(std::lround(between(from, to, share)));
}

template<class Vector>
requires requires {
    Vector::length();
}
Vector blend(Vector from, const Vector& to, double share) {
    for (int i = 0; i < Vector::length(); ++i)
        from[i] = blend(from[i], to[i], share);
    return from;
}

template<class Element>
SharedList<Element> blend(SharedList<Element> from, const SharedList<Element>& to, double share) {
    if (from.size() == to.size())
        std::ranges::transform(from, to, from.edit().begin(),
                               [share](const Element& a, const Element& b) { return blend(a, b, share); });
    return from;
}

template<class T>
Value mixAs(const Value& from, const Value& to, double share) {
    return blend(std::get<T>(from), std::get<T>(to), share);
}

} // namespace

bool canMix(const ParamRow& row) {
    switch (row.kind) {
    case Kind::Bool:
    case Kind::Enum:
    case Kind::Text:
    case Kind::IndexList:
        return false;
    case Kind::Int:
        return row.member != memberId<&Unit::texture>;
    case Kind::Float:
    case Kind::Vec3:
    case Kind::Vec4:
    case Kind::Color:
    case Kind::Matrix:
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
        return true;
    }
    return false;
}

Value mixed(const ParamRow& row, const Value& from, const Value& to, double share) {
    if (share <= 0)
        return from;
    if (share >= 1)
        return to;
    if (!canMix(row))
        return from;
    switch (row.kind) {
    case Kind::Int:
        return mixAs<int>(from, to, share);
    case Kind::Float:
        return mixAs<float>(from, to, share);
    case Kind::Vec3:
        return mixAs<glm::vec3>(from, to, share);
    case Kind::Vec4:
    case Kind::Color:
        return mixAs<glm::vec4>(from, to, share);
    case Kind::Matrix:
        return mixAs<glm::mat4>(from, to, share);
    case Kind::PointList:
        return mixAs<SharedList<glm::vec3>>(from, to, share);
    case Kind::ColorList:
    case Kind::TexCoordList:
        return mixAs<SharedList<glm::vec4>>(from, to, share);
    default:
        return from;
    }
}

} // namespace texplorer

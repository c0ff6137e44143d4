#include "texplorer/scene/params/param_json.h"

namespace texplorer {
namespace {

template<class Vector>
OrderedJson jsonVector(const Vector& vector) {
    OrderedJson numbers = OrderedJson::array();
    for (int i = 0; i < Vector::length(); ++i)
        numbers.push_back(vector[i]);
    return numbers;
}

} // namespace

OrderedJson jsonValue(const ParamRow& row, const Value& value) {
    switch (row.kind) {
    case Kind::Bool:
        return std::get<bool>(value);
    case Kind::Int:
        return std::get<int>(value);
    case Kind::Float:
        return std::get<float>(value);
    case Kind::Vec3:
        return jsonVector(std::get<glm::vec3>(value));
    case Kind::Vec4:
    case Kind::Color:
        return jsonVector(std::get<glm::vec4>(value));
    case Kind::Enum:
    case Kind::Text:
        return formatValue(row, value);
    case Kind::Matrix: {
        OrderedJson numbers = OrderedJson::array();
        for (int i = 0; i < 16; ++i)
            numbers.push_back(std::get<glm::mat4>(value)[i / 4][i % 4]);
        return numbers;
    }
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
    case Kind::IndexList:
        return OrderedJson::array();
    }
    return {};
}

} // namespace texplorer

// What a row accepts, and its values as text.

#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/text/nearest_name.h"
#include "texplorer/text/utf8.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace texplorer {
namespace {

Sentence withUnit(const Range& range) {
    const std::string min = formatNumber(range.min);
    const std::string max = formatNumber(range.max);
    return range.unit.empty() ? Sentence("from {0} to {1}", ProperName{min}, ProperName{max})
                              : Sentence("from {0} to {1} {2}", ProperName{min}, ProperName{max}, range.unit);
}

Result<void> refuse(const ParamRow& row, const Sentence& found) {
    return fail(ErrorCode::OutOfRange, Sentence("expected {0}, found {1}", describeAccepted(row), found));
}

std::size_t alternativeOf(Kind kind) {
    switch (kind) {
    case Kind::Bool:
        return Value(false).index();
    case Kind::Int:
        return Value(0).index();
    case Kind::Float:
        return Value(0.0F).index();
    case Kind::Vec3:
        return Value(glm::vec3()).index();
    case Kind::Vec4:
    case Kind::Color:
        return Value(glm::vec4()).index();
    case Kind::Matrix:
        return Value(glm::mat4()).index();
    case Kind::Enum:
        return Value(EnumValue{}).index();
    case Kind::Text:
        return Value(std::string()).index();
    case Kind::PointList:
        return Value(SharedList<glm::vec3>()).index();
    case Kind::ColorList:
    case Kind::TexCoordList:
        return Value(SharedList<glm::vec4>()).index();
    case Kind::IndexList:
        return Value(SharedList<int>()).index();
    }
    return std::variant_npos;
}

bool accepts(const Range& range, float number) {
    return number >= range.min && number <= range.max; // false for NaN
}

template<class Vector>
Result<void> checkComponents(const ParamRow& row, const Vector& vector) {
    for (int i = 0; i < Vector::length(); ++i)
        if (!accepts(row.range, vector[i]))
            return refuse(row, formatNumber(vector[i]));
    return {};
}

Result<void> checkText(const ParamRow& row, const std::string& text) {
    if (text.size() > maxTextBytes)
        return refuse(row, Sentence("{0} bytes", text.size()));
    if (text.find('\0') != std::string::npos)
        return refuse(row, N_("a zero byte in it"));
    if (!isUtf8(text))
        return refuse(row, N_("bytes that are not UTF-8"));
    return {};
}

Result<void> checkMatrix(const ParamRow& row, const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int i = 0; i < 4; ++i)
            if (!accepts(row.range, matrix[column][i]))
                return refuse(row, formatNumber(matrix[column][i]));
    return {};
}

Result<void> checkLength(const ParamRow& row, std::size_t count) {
    if (count <= row.maxCount)
        return {};
    return fail(ErrorCode::TooLarge,
                Sentence("expected at most {0} elements, found {1}", row.maxCount, count));
}

Result<void> checkElements(const ParamRow& row, const std::vector<glm::vec4>& list) {
    if (auto fits = checkLength(row, list.size()); !fits)
        return fits;
    const auto fits = [&](float number) {
        return row.kind == Kind::ColorList ? accepts(row.range, number) : std::isfinite(number);
    };
    for (std::size_t i = 0; i < list.size(); ++i)
        for (int c = 0; c < 4; ++c)
            if (!fits(list[i][c]))
                return refuse(row, Sentence("{0} at vertex {1}", ProperName{formatNumber(list[i][c])}, i));
    return {};
}

Result<void> checkIndices(const ParamRow& row, const std::vector<int>& list) {
    if (auto fits = checkLength(row, list.size()); !fits)
        return fits;
    for (const int index : list)
        if (!accepts(row.range, static_cast<float>(index)))
            return refuse(row, std::to_string(index));
    return {};
}

std::string_view trim(std::string_view text) {
    constexpr std::string_view blank = " \t";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(trim(text.substr(0, end)));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

/// The whole text as a finite number.
template<class Number>
std::optional<Number> parseNumber(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || text.empty())
        return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>)
        if (!std::isfinite(number))
            return std::nullopt;
    return number;
}

/// Fills as many components as the text has, from `minCount` to 4.
std::optional<glm::vec4> parseVector(std::string_view text, std::size_t minCount, std::size_t maxCount,
                                     glm::vec4 vector) {
    const auto parts = split(text, ',');
    if (parts.size() < minCount || parts.size() > maxCount)
        return std::nullopt;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto number = parseNumber<float>(parts[i]);
        if (!number)
            return std::nullopt;
        vector[static_cast<glm::vec4::length_type>(i)] = *number;
    }
    return vector;
}

std::optional<Value> readElements(Kind kind, const ElementNumbers& numbers, std::string_view text) {
    std::vector<glm::vec4> list;
    if (text.empty())
        return listOf(kind, list);
    for (const std::string_view vertex : split(text, ';')) {
        const auto element = parseVector(vertex, numbers.min, numbers.max, numbers.rest);
        if (!element)
            return std::nullopt;
        list.push_back(*element);
    }
    return listOf(kind, list);
}

std::optional<Value> readIndices(std::string_view text) {
    std::vector<int> list;
    if (text.empty())
        return list;
    for (const std::string_view part : split(text, ',')) {
        const auto number = parseNumber<int>(part);
        if (!number)
            return std::nullopt;
        list.push_back(*number);
    }
    return list;
}

std::optional<Value> readMatrix(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 16)
        return std::nullopt;
    glm::mat4 matrix{};
    for (int i = 0; i < 16; ++i) {
        const auto number = parseNumber<float>(parts[static_cast<std::size_t>(i)]);
        if (!number)
            return std::nullopt;
        matrix[i / 4][i % 4] = *number;
    }
    return matrix;
}

/// The value that the text spells, whether or not its number is in range.
std::optional<Value> readValue(const ParamRow& row, std::string_view text) {
    switch (row.kind) {
    case Kind::Bool:
        if (text == "true" || text == "false")
            return text == "true";
        return std::nullopt;
    case Kind::Int:
        if (const auto number = parseNumber<int>(text))
            return *number;
        return std::nullopt;
    case Kind::Float:
        if (const auto number = parseNumber<float>(text))
            return *number;
        return std::nullopt;
    case Kind::Vec3:
        if (const auto vector = parseVector(text, 3, 3, {}))
            return glm::vec3(*vector);
        return std::nullopt;
    case Kind::Vec4:
    case Kind::Color:
        if (const auto vector = parseVector(text, 4, 4, {}))
            return *vector;
        return std::nullopt;
    case Kind::Enum:
        if (const EnumRow* found = findRow(row.choices, text))
            return EnumValue{found->value};
        return std::nullopt;
    case Kind::Matrix:
        return readMatrix(text);
    case Kind::Text:
        return std::string(text);
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
        return readElements(row.kind, *elementNumbers(row.kind), text);
    case Kind::IndexList:
        return readIndices(text);
    }
    return std::nullopt;
}

constexpr ElementNumbers pointNumbers{3, 3};
constexpr ElementNumbers colorNumbers{3, 4};
constexpr ElementNumbers texCoordNumbers{2, 4};

} // namespace

std::size_t ElementNumbers::needed(glm::vec4 element) const {
    std::size_t count = max;
    while (count > min && element[static_cast<int>(count) - 1] == rest[static_cast<int>(count) - 1])
        --count;
    return count;
}

std::optional<ElementNumbers> elementNumbers(Kind kind) {
    switch (kind) {
    case Kind::PointList:
        return pointNumbers;
    case Kind::ColorList:
        return colorNumbers;
    case Kind::TexCoordList:
        return texCoordNumbers;
    default:
        return std::nullopt;
    }
}

std::vector<glm::vec4> elementsOf(const Value& value) {
    if (const auto* coords = std::get_if<SharedList<glm::vec4>>(&value))
        return *coords;
    std::vector<glm::vec4> elements;
    if (const auto* points = std::get_if<SharedList<glm::vec3>>(&value)) {
        elements.reserve(points->size());
        for (const glm::vec3& point : *points)
            elements.emplace_back(point, 1);
    }
    return elements;
}

Value listOf(Kind kind, const std::vector<glm::vec4>& elements) {
    if (kind == Kind::PointList)
        return std::vector<glm::vec3>(elements.begin(), elements.end());
    return elements;
}

std::size_t listSize(const Value& value) {
    if (const auto* points = std::get_if<SharedList<glm::vec3>>(&value))
        return points->size();
    if (const auto* vectors = std::get_if<SharedList<glm::vec4>>(&value))
        return vectors->size();
    const auto* indices = std::get_if<SharedList<int>>(&value);
    return indices ? indices->size() : 0;
}

bool isList(Kind kind) {
    return kind == Kind::IndexList || elementNumbers(kind).has_value();
}

std::string formatTexCoord(glm::vec4 coord) {
    return formatNumbers({&coord.x, texCoordNumbers.needed(coord)});
}

Result<glm::vec4> parseTexCoord(std::string_view text) {
    if (const auto coord = parseVector(text, texCoordNumbers.min, texCoordNumbers.max, texCoordNumbers.rest))
        return *coord;
    return fail(ErrorCode::OutOfRange,
                Sentence("expected 2 to 4 finite numbers separated by commas, found {0}", inQuotes(text)));
}

Sentence describeAccepted(const ParamRow& row) {
    switch (row.kind) {
    case Kind::Bool:
        return N_("true or false");
    case Kind::Int:
        return Sentence("a whole number {0}", withUnit(row.range));
    case Kind::Float:
        return Sentence("a number {0}", withUnit(row.range));
    case Kind::Vec3:
        return Sentence("3 numbers, each {0}", withUnit(row.range));
    case Kind::Vec4:
        return Sentence("4 numbers, each {0}", withUnit(row.range));
    case Kind::Color:
        return Sentence("4 numbers (red, green, blue, alpha), each {0}", withUnit(row.range));
    case Kind::Enum:
        return Sentence("one of {0}", ProperName{listNames(row.choices)});
    case Kind::Text:
        if (row.member == memberId<&KeyFrame::value>)
            return Sentence(
                "a number between -3.4e38 and 3.4e38, an array of up to 16, true, false or UTF-8 text of at most {0} bytes",
                maxTextBytes);
        return Sentence("UTF-8 text of at most {0} bytes", maxTextBytes);
    case Kind::Matrix:
        return Sentence("16 numbers, each {0}", withUnit(row.range));
    case Kind::PointList:
        return N_("3 finite numbers for each vertex");
    case Kind::ColorList:
        return Sentence("3 or 4 numbers (red, green, blue, alpha) for each vertex, each {0}",
                        withUnit(row.range));
    case Kind::TexCoordList:
        return N_("2 to 4 finite numbers for each vertex");
    case Kind::IndexList:
        return Sentence("whole numbers, each {0}", withUnit(row.range));
    }
    return {};
}

Result<void> checkValue(const ParamRow& row, const Value& value) {
    if (value.index() != alternativeOf(row.kind))
        return refuse(row, N_("a value of another kind"));
    switch (row.kind) {
    case Kind::Bool:
        return {};
    case Kind::Int:
        if (!accepts(row.range, static_cast<float>(std::get<int>(value))))
            return refuse(row, std::to_string(std::get<int>(value)));
        return {};
    case Kind::Float:
        if (!accepts(row.range, std::get<float>(value)))
            return refuse(row, formatNumber(std::get<float>(value)));
        return {};
    case Kind::Vec3:
        return checkComponents(row, std::get<glm::vec3>(value));
    case Kind::Vec4:
    case Kind::Color:
        return checkComponents(row, std::get<glm::vec4>(value));
    case Kind::Enum:
        if (!findRow(row.choices, std::get<EnumValue>(value).number))
            return refuse(row, Sentence("the number {0}", std::get<EnumValue>(value).number));
        return {};
    case Kind::Text:
        return checkText(row, std::get<std::string>(value));
    case Kind::Matrix:
        return checkMatrix(row, std::get<glm::mat4>(value));
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
        return checkElements(row, elementsOf(value));
    case Kind::IndexList:
        return checkIndices(row, std::get<SharedList<int>>(value));
    }
    return {};
}

std::string formatValue(const ParamRow& row, const Value& value) {
    switch (row.kind) {
    case Kind::Bool:
        return std::get<bool>(value) ? "true" : "false";
    case Kind::Int:
        return std::to_string(std::get<int>(value));
    case Kind::Float:
        return formatNumber(std::get<float>(value));
    case Kind::Vec3:
        return formatNumbers({&std::get<glm::vec3>(value).x, 3});
    case Kind::Vec4:
    case Kind::Color:
        return formatNumbers({&std::get<glm::vec4>(value).x, 4});
    case Kind::Enum: {
        const EnumRow* found = findRow(row.choices, std::get<EnumValue>(value).number);
        return found ? std::string(found->name) : std::to_string(std::get<EnumValue>(value).number);
    }
    case Kind::Text:
        return std::get<std::string>(value);
    case Kind::Matrix:
        return formatNumbers({&std::get<glm::mat4>(value)[0].x, 16});
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList: {
        const ElementNumbers numbers = *elementNumbers(row.kind);
        std::string text;
        for (const glm::vec4& element : elementsOf(value))
            text.append(text.empty() ? "" : ";").append(formatNumbers({&element.x, numbers.needed(element)}));
        return text;
    }
    case Kind::IndexList:
        return fmt::format("{}", fmt::join(std::get<SharedList<int>>(value), ","));
    }
    return {};
}

Result<Value> parseValue(const ParamRow& row, std::string_view text) {
    const bool exact = row.kind == Kind::Text || row.kind == Kind::Enum;
    const auto value = readValue(row, exact ? text : trim(text));
    if (!value) {
        Sentence found = ProperName{inQuotes(text)};
        if (row.kind == Kind::Enum) {
            std::vector<std::string_view> names;
            for (const EnumRow& choice : row.choices)
                names.push_back(choice.name);
            if (const auto near = nearestName(text, names); !near.empty())
                found = Sentence("{0}; did you mean {1}?", found, ProperName{inQuotes(near)});
        }
        return fail(refuse(row, found).error());
    }
    if (auto checked = checkValue(row, *value); !checked)
        return fail(std::move(checked.error()));
    return *value;
}

} // namespace texplorer

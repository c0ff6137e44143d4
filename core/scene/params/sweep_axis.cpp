#include "texplorer/scene/params/sweep_axis.h"

#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace texplorer {
namespace {

constexpr std::size_t fewValues = 5;
constexpr double manySteps = 1000;
/// Of a number with many steps, so many of them lie between two values.
constexpr float stepsBetween = 50;
constexpr float wholeStepsBetween = 20;
constexpr std::string_view rangeSign = "..";

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
        text.remove_suffix(1);
    return text;
}

bool isNumber(Kind kind) {
    return kind == Kind::Int || kind == Kind::Float;
}

/// The number without what rounding left of it: 0.3, not 0.30000000000000004.
std::string numberText(Kind kind, double number) {
    return kind == Kind::Int ? fmt::format("{}", std::llround(number)) : fmt::format("{:.6g}", number);
}

std::vector<std::string> numbersBetween(Kind kind, double first, double last, std::size_t count) {
    std::vector<std::string> numbers;
    numbers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        numbers.push_back(numberText(kind, first + (last - first) * share));
    }
    return numbers;
}

struct NumberRange {
    double first;
    double last;
    std::size_t count;
};

template<class Number>
std::optional<Number> wholeText(std::string_view text) {
    Number number{};
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() && !text.empty() ? std::optional(number)
                                                                                      : std::nullopt;
}

Result<NumberRange> parseRange(std::string_view text) {
    const std::size_t sign = text.find(rangeSign);
    const std::size_t slash = text.find('/', sign);
    const auto first = wholeText<float>(trimmed(text.substr(0, sign)));
    const auto last = wholeText<float>(trimmed(text.substr(sign + 2, slash - sign - 2)));
    if (!first || !last || !std::isfinite(*first) || !std::isfinite(*last))
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected two numbers, as in 0..4/5, found {0}", inQuotes(text)));
    if (slash == std::string_view::npos)
        return NumberRange{*first, *last, fewValues};
    const std::string_view counted = trimmed(text.substr(slash + 1));
    const auto count = wholeText<std::size_t>(counted);
    if (!count || *count < 2 || *count > maxAxisValues)
        return fail(ErrorCode::OutOfRange, Sentence("expected 2 to {0} values after the slash, found {1}",
                                                    maxAxisValues, inQuotes(counted)));
    return NumberRange{*first, *last, *count};
}

std::vector<std::string_view> partsOf(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

/// As they are written, with the numbers of ranges.
Result<std::vector<std::string>> listed(const ParamRow& row, std::string_view text) {
    const bool hasComponents = row.kind == Kind::Vec3 || row.kind == Kind::Vec4 || row.kind == Kind::Color ||
                               elementNumbers(row.kind);
    std::vector<std::string> values;
    for (const std::string_view part : partsOf(text, hasComponents ? ';' : ',')) {
        if (!isNumber(row.kind) || part.find(rangeSign) == std::string_view::npos) {
            values.emplace_back(part);
            continue;
        }
        const Result<NumberRange> range = parseRange(part);
        if (!range)
            return fail(range.error());
        for (std::string& number : numbersBetween(row.kind, range->first, range->last, range->count))
            values.push_back(std::move(number));
    }
    return values;
}

enum class Repeats : std::uint8_t { Refused, LeftOut };

/// Each as formatValue writes it, none of them twice.
Result<std::vector<std::string>> checked(const ParamRow& row, const std::vector<std::string>& given,
                                         Repeats repeats) {
    std::vector<std::string> values;
    for (const std::string& text : given) {
        const Result<Value> value = parseValue(row, text);
        if (!value)
            return fail(value.error());
        if (isList(row.kind) && listSize(*value) != 1) // the value of an element
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected {0}, found {1}", describeAccepted(row), inQuotes(text)));
        std::string written = formatValue(row, *value);
        if (std::ranges::find(values, written) == values.end())
            values.push_back(std::move(written));
        else if (repeats == Repeats::Refused)
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected each value once, found {0} twice", inQuotes(written)));
    }
    if (values.size() > maxAxisValues)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} values, found {1}", maxAxisValues, values.size()));
    return values;
}

std::vector<std::string> suggestedNumbers(const ParamRow& row, double current) {
    const double min = row.range.min;
    const double max = row.range.max;
    if (min > 0 && max >= min * 8 && max <= min * 64) {
        std::vector<std::string> doubled;
        for (double number = min; number <= max; number *= 2)
            doubled.push_back(numberText(row.kind, number));
        return doubled;
    }
    if (max - min <= manySteps * double{row.range.step})
        return numbersBetween(row.kind, min, max, fewValues);
    const double step = row.kind == Kind::Int ? std::max(1.0F, wholeStepsBetween * row.range.step)
                                              : stepsBetween * row.range.step;
    const double extent = step * (fewValues - 1);
    const double first = std::clamp(current - extent / 2, min, std::max(min, max - extent));
    return numbersBetween(row.kind, first, std::min(first + extent, max), fewValues);
}

} // namespace

bool canSweep(const ParamRow& row) {
    switch (row.kind) {
    case Kind::Bool:
    case Kind::Int:
    case Kind::Float:
    case Kind::Vec3:
    case Kind::Vec4:
    case Kind::Color:
    case Kind::Enum:
        return true;
    default:
        return false;
    }
}

std::vector<std::string> suggestedValues(const ParamRow& row, const Value& current) {
    std::vector<std::string> values;
    if (row.kind == Kind::Bool)
        values = {"false", "true"};
    for (const EnumRow& choice : row.choices)
        values.emplace_back(choice.name);
    if (const auto* whole = std::get_if<int>(&current))
        values = suggestedNumbers(row, *whole);
    else if (const auto* number = std::get_if<float>(&current))
        values = suggestedNumbers(row, *number);
    Result<std::vector<std::string>> suited = checked(row, values, Repeats::LeftOut);
    return suited ? *std::move(suited) : std::vector<std::string>();
}

namespace {

Result<SweepAxis> axisOf(const Scene& scene, std::string_view path, std::string_view values,
                         Repeats repeats) {
    const Result<ParamAt> at = paramAt(scene, path);
    if (!at)
        return fail(at.error());
    const auto refuse = [&](const Error& error) {
        return fail(error.code, error.message, std::string(path));
    };
    const ParamRow& row = *at->row;
    const bool isElement = isList(row.kind) && path.ends_with(']');
    if (isList(row.kind) && !isElement && hasElements(row))
        return refuse({ErrorCode::Unsupported,
                       Sentence("expected one element of the list, as in {0}[0]", ProperName{path}),
                       {}});
    if (!isElement && !canSweep(row))
        return refuse(
            {ErrorCode::Unsupported, N_("expected a choice, a number, a colour or true or false"), {}});
    const std::string_view wanted = trimmed(values);
    const bool all = wanted == "*";
    Result<std::vector<std::string>> given = all ? suggestedValues(row, at->value) : listed(row, wanted);
    if (given && given->empty())
        return refuse({ErrorCode::OutOfRange, N_("expected values: there are no default values here"), {}});
    if (all || wanted.find(rangeSign) != std::string_view::npos) // not written out one by one
        repeats = Repeats::LeftOut;
    Result<std::vector<std::string>> made =
        given.and_then([&](const std::vector<std::string>& each) { return checked(row, each, repeats); });
    if (!made)
        return refuse(made.error());
    return SweepAxis{std::string(path), *std::move(made)};
}

} // namespace

Result<SweepAxis> sweepAxis(const Scene& scene, std::string_view path, std::string_view values) {
    return axisOf(scene, path, values, Repeats::LeftOut);
}

Result<SweepAxis> parseSweepAxis(const Scene& scene, std::string_view text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected PATH=VALUES, as in textures[0].maxAnisotropy=1,2,4, found {0}",
                             inQuotes(text)));
    return axisOf(scene, trimmed(text.substr(0, sign)), text.substr(sign + 1), Repeats::Refused);
}

} // namespace texplorer

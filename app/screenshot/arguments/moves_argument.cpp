#include "app/screenshot/arguments/moves_argument.h"

#include "texplorer/base/sentence.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/value_mix.h"

#include <cmath>

namespace texplorer::screenshot {
namespace {

constexpr std::string_view dots = "..";

std::vector<std::string> partsOf(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t end = text.find(dots); end != std::string_view::npos; end = text.find(dots)) {
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(end + dots.size());
    }
    parts.emplace_back(text);
    return parts;
}

Result<std::vector<std::string>> allChoices(const ParamRow& row, const std::string& path) {
    if (row.kind == Kind::Bool)
        return std::vector<std::string>{"false", "true"};
    if (row.kind != Kind::Enum)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected values to move between, as in A..B: * is for names, this is {0}",
                             describeAccepted(row)),
                    path);
    std::vector<std::string> names;
    for (const EnumRow& each : row.choices)
        names.emplace_back(each.name);
    return names;
}

/// Not later than asked for: a picture that is drawn at that time shows it.
float keyTime(double time) {
    const auto rounded = static_cast<float>(time);
    return double{rounded} > time ? std::nextafter(rounded, 0.0F) : rounded;
}

} // namespace

std::vector<std::string> takeMoves(std::vector<std::string>& assignments) {
    std::vector<std::string> moves;
    std::erase_if(assignments, [&](const std::string& each) {
        const std::string_view value = std::string_view(each).substr(each.find('=') + 1);
        const bool moving = value == "*" || value.find(dots) != std::string_view::npos;
        if (moving)
            moves.push_back(each);
        return moving;
    });
    return moves;
}

Result<void> putMove(Scene& scene, const std::string& assignment, const MoveTimes& times) {
    const std::size_t equals = assignment.find('=');
    const std::string path = assignment.substr(0, equals);
    const std::string text = assignment.substr(equals + 1);
    const Result<const ParamRow*> row = rowAt(scene, path);
    if (!row)
        return fail(row.error());
    if ((*row)->kind == Kind::Text)
        return setParam(scene, path, text);
    Result<std::vector<std::string>> values = partsOf(text);
    if (text == "*")
        values = allChoices(**row, path);
    if (!values)
        return fail(values.error());
    std::erase_if(scene.timeline.keys, [&](const KeyFrame& key) { return key.path == path; });
    if (scene.timeline.keys.size() + values->size() > maxKeyFrames)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} in a scene",
                             Sentence::plural("{0} key frame", "{0} key frames", maxKeyFrames)),
                    path);
    const bool mixes = canMix(**row);
    const auto spans = static_cast<double>(mixes ? values->size() - 1 : values->size());
    for (std::size_t i = 0; i < values->size(); ++i) {
        const std::string& value = (*values)[i];
        if (Result<void> fits = checkMovable(scene, path, value); !fits)
            return fits;
        scene.timeline.keys.push_back({keyTime(times.begin + times.seconds * static_cast<double>(i) / spans),
                                       path, value, mixes ? times.easing : Easing::Hold});
    }
    return {};
}

} // namespace texplorer::screenshot

#include "texplorer/emit/key_frames.h"

#include "texplorer/emit/code_writer.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/value_mix.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace texplorer::emit {
namespace {

/// Indices without zeros before them: "textures[00]" is "textures[0]".
std::string canonical(std::string_view path) {
    std::string text;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool isLeading = path[i] == '0' && text.ends_with('[') && i + 1 < path.size() &&
                               std::isdigit(static_cast<unsigned char>(path[i + 1])) != 0;
        if (!isLeading)
            text += path[i];
    }
    return text;
}

bool isNumber(Kind kind) {
    return kind == Kind::Float || kind == Kind::Vec3 || kind == Kind::Vec4 || kind == Kind::Color ||
           kind == Kind::Matrix;
}

/// Whether a part has the value of its parameter, and nothing that was made of it.
bool isValueOf(const Part& part, const ParamRow& row, const Value& value) {
    switch (row.kind) {
    case Kind::Bool:
        return part.text == booleanName(std::get<bool>(value));
    case Kind::Enum: {
        const EnumRow* found = findRow(row.choices, std::get<EnumValue>(value).number);
        return found && part.text == found->name;
    }
    case Kind::Int:
        return part.text == fmt::format("{}", std::get<int>(value));
    default:
        break;
    }
    if (!isNumber(row.kind))
        return false;
    const float number = numberIn(value, static_cast<std::size_t>(std::max(part.component, 0)));
    const float shown = part.negated ? 0 - number : number;
    return part.text == literal(shown, Literal::Float) || part.text == literal(shown, Literal::Double);
}

} // namespace

std::size_t MovingParam::components() const {
    if (!canMix(*row))
        return 0;
    switch (row->kind) {
    case Kind::Vec3:
        return 3;
    case Kind::Vec4:
    case Kind::Color:
        return 4;
    case Kind::Matrix:
        return 16;
    default:
        return 1;
    }
}

KeyFrames::KeyFrames(const Scene& scene) {
    Scene standing = scene; // each key's value as the scene has it
    standing.timeline.keys.clear();
    for (const Track& track : tracksOf(scene.timeline)) {
        MovingParam param{};
        for (const KeyFrame* key : track.keys) {
            if (!putBetween(standing, track.path, key->value, key->value, 0))
                continue;
            const Result<ParamAt> at = paramAt(standing, track.path);
            if (!at)
                continue;
            param.row = at->row;
            param.keys.push_back({key->time, key->easing, at->value, key->value});
        }
        const std::string path = canonical(track.path);
        param.variable = variableOf(path);
        params_.erase(path); // of two that are written differently the last one counts
        if (std::ranges::any_of(
                param.keys, [&](const MovingParam::Key& key) { return key.value != param.keys[0].value; }))
            params_.emplace(path, std::move(param));
    }
}

bool KeyFrames::movesBelow(std::string_view prefix) const {
    const auto next = params_.lower_bound(prefix);
    return next != params_.end() && next->first.starts_with(prefix);
}

bool KeyFrames::isUsed() const {
    return std::ranges::any_of(params_, [](const auto& each) { return each.second.isUsed; });
}

const std::string& KeyFrames::use(std::string_view path) {
    MovingParam& param = params_.find(path)->second;
    param.isUsed = true;
    return param.variable;
}

bool KeyFrames::isSwitched(std::string_view path, bool on) const {
    const Result<ParamAt> at = paramAt(*standing_, path);
    const bool* value = at ? std::get_if<bool>(&at->value) : nullptr;
    return value && *value == on;
}

void KeyFrames::replace(Part& part) {
    const Result<ParamAt> at = paramAt(*standing_, part.path);
    if (part.kind == Part::Kind::Plain) { // the name of an array that holds all of it
        part.text = use(part.path);
        return;
    }
    if (!at || !isValueOf(part, *at->row, at->value))
        return refuse(part.path);
    part.text = part.negated ? "-" : "";
    part.text += use(part.path);
    if (part.component >= 0)
        part.text += fmt::format("[{}]", part.component);
    part.kind = Part::Kind::Plain;
}

const std::string& KeyFrames::refused() const {
    const auto isForgotten = [](const auto& each) { return each.second.isLeft && !each.second.isUsed; };
    const auto forgotten = std::ranges::find_if(params_, isForgotten);
    return refused_.empty() && forgotten != params_.end() ? forgotten->first : refused_;
}

void KeyFrames::refuse(std::string_view path) {
    if (refused_.empty())
        refused_ = path;
}

float numberIn(const Value& value, std::size_t component) {
    const auto at = static_cast<int>(component);
    if (const auto* whole = std::get_if<int>(&value))
        return static_cast<float>(*whole);
    if (const auto* one = std::get_if<float>(&value))
        return *one;
    if (const auto* three = std::get_if<glm::vec3>(&value))
        return (*three)[at];
    if (const auto* four = std::get_if<glm::vec4>(&value))
        return (*four)[at];
    if (const auto* matrix = std::get_if<glm::mat4>(&value))
        return (*matrix)[at / 4][at % 4];
    return 0;
}

std::string variableOf(std::string_view path) {
    std::string name;
    bool begins = false;
    for (const char c : path) {
        if (c == '[' && name.ends_with("ses")) // passes[0]: pass0
            name.resize(name.size() - 2);
        else if (c == '[' && name.ends_with('s'))
            name.pop_back();
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
            begins = begins || c == '.';
            continue;
        }
        name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = false;
    }
    return name;
}

} // namespace texplorer::emit

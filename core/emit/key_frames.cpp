#include "texplorer/emit/key_frames.h"

#include "texplorer/emit/code_writer.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/params/value_mix.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <set>
#include <span>

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

bool isOneOf(MemberId member, std::span<const MemberId> members) {
    return std::ranges::find(members, member) != members.end();
}

/// Why a program can't change a parameter in each frame, by a call, a uniform or a term of a matrix; empty:
/// it can. The others decide which calls, functions and numbers it has.
Sentence obstacleTo(Flavour flavour, const ParamRow& row) {
    constexpr std::array ofTexels{memberId<&Texture::internalFormat>,   memberId<&Texture::border>,
                                  memberId<&Texture::compressedFormat>, memberId<&Texture::stencilColor>,
                                  memberId<&ImageStep::factor>,         memberId<&ImageStep::bias>,
                                  memberId<&ImageStep::amount>,         memberId<&ImageStep::share>,
                                  memberId<&ImageStep::width>,          memberId<&ImageStep::height>,
                                  memberId<&Texture::mipCoverage>};
    constexpr std::array ofShape{memberId<&Model::shape>, memberId<&MeshData::primitive>};
    constexpr std::array counts{memberId<&Model::slices>, memberId<&Model::stacks>};
    constexpr std::array fixed{memberId<&Material::colorMaterial>, memberId<&Unit::target>};
    // What else moves is a part of the shaders.
    constexpr std::array withShaders{memberId<&Material::colorMaterial>, memberId<&Pass::depthTest>,
                                     memberId<&Pass::depthFunc>,         memberId<&Pass::blend>,
                                     memberId<&Pass::blendSrc>,          memberId<&Pass::blendDst>,
                                     memberId<&Pass::seamlessCubeMap>,   memberId<&Unit::texture>,
                                     memberId<&Texture::magFilter>,      memberId<&Texture::minFilter>,
                                     memberId<&Texture::wrapS>,          memberId<&Texture::wrapT>,
                                     memberId<&Texture::wrapR>,          memberId<&Texture::baseLevel>,
                                     memberId<&Texture::maxLevel>,       memberId<&Texture::compareFunc>};
    const auto isOf = [&](const StructTable& table) {
        return std::ranges::find(table.params, row.member, &ParamRow::member) != table.params.end();
    };
    if (isOneOf(row.member, ofTexels) || isOf(uploadTable()) || isOf(subimageTable()))
        return N_("texels are made only when the program starts");
    if (isOneOf(row.member, ofShape))
        return N_("shapes are made only when the program starts");
    if (isNumber(row.kind) || isOneOf(row.member, counts))
        return {};
    if (row.kind != Kind::Bool && row.kind != Kind::Enum && row.kind != Kind::Int)
        return N_("it is a fixed part of the program");
    const bool isGlsl = flavour == Flavour::Glsl;
    const bool moves =
        isGlsl ? isOneOf(row.member, withShaders) : !row.glCall.empty() && !isOneOf(row.member, fixed);
    return moves    ? Sentence()
           : isGlsl ? N_("its values need different shaders or calls")
                    : N_("its values need different calls");
}

/// The value in the standing scene: one between two keys of a number, true of a switch, or the first one.
Value standingValue(const MovingParam& param) {
    constexpr double share = 0.382;
    if (param.row->kind == Kind::Bool)
        return true;
    const auto differs = std::ranges::adjacent_find(
        param.keys, [](const auto& one, const auto& next) { return one.value != next.value; });
    return mixed(*param.row, differs->value, std::next(differs)->value, share);
}

/// The values between which a decision of a program can change: the least and the greatest of each number,
/// all counts as far as texture levels go, all names.
std::vector<std::string> valuesOf(const MovingParam& param) {
    constexpr int maxLevels = 16;
    std::set<std::string> values;
    for (std::size_t i = 0; i < param.components(); ++i) {
        const auto number = [&](const MovingParam::Key& key) { return numberIn(key.value, i); };
        const auto [least, most] = std::ranges::minmax_element(param.keys, {}, number);
        values.insert({least->text, most->text});
        if (param.row->kind != Kind::Int)
            continue;
        const int last = std::min(std::get<int>(most->value), maxLevels);
        for (int between = std::get<int>(least->value) + 1; between < last; ++between)
            values.insert(fmt::format("{}", between));
    }
    for (auto key = param.keys.begin(); param.components() == 0 && key != param.keys.end(); ++key)
        values.insert(key->text);
    return {values.begin(), values.end()};
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

KeyFrames::KeyFrames(Flavour flavour, const Scene& scene)
    : standing_(sceneAt(scene, 0)) {
    Scene standing = scene; // each key's value as the scene has it
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
        if (std::ranges::all_of(
                param.keys, [&](const MovingParam::Key& key) { return key.value == param.keys[0].value; }))
            continue;
        if (Sentence obstacle = obstacleTo(flavour, *param.row); !obstacle.empty()) {
            refuse(path, std::move(obstacle));
            continue;
        }
        param.standing = standingValue(param);
        params_.emplace(path, std::move(param));
    }
    for (const auto& [path, param] : params_) {
        const std::string text = formatValue(*param.row, param.standing);
        static_cast<void>(putBetween(standing_, path, text, text, 0));
    }
}

void KeyFrames::standAt(Scene scene) {
    standing_ = std::move(scene);
    for (auto& [path, param] : params_)
        param.standing = paramAt(standing_, path)->value;
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

void KeyFrames::replace(Part& part) {
    if (part.kind == Part::Kind::Plain) { // the name of an array that holds all of it
        part.text = use(part.path);
        return;
    }
    const MovingParam& param = params_.find(part.path)->second;
    if (!isValueOf(part, *param.row, param.standing))
        return refuse(part.path, N_("the program has a number that is computed from it"));
    part.text = part.negated ? "-" : "";
    part.text += use(part.path);
    if (part.component >= 0)
        part.text += fmt::format("[{}]", part.component);
    part.kind = Part::Kind::Plain;
}

RefusedParam KeyFrames::refused() const {
    const auto isForgotten = [](const auto& each) { return each.second.isLeft && !each.second.isUsed; };
    const auto forgotten = std::ranges::find_if(params_, isForgotten);
    return refused_.path.empty() && forgotten != params_.end()
               ? RefusedParam{forgotten->first, N_("no call of a frame sets it")}
               : refused_;
}

void KeyFrames::refuse(std::string_view path, Sentence why) {
    if (refused_.path.empty())
        refused_ = {std::string(path), std::move(why)};
}

std::vector<int> KeyFrames::indicesOf(std::string_view path, int now) const {
    if (!moves(path))
        return {now};
    std::vector<int> indices;
    for (const MovingParam::Key& key : params_.find(path)->second.keys)
        indices.push_back(std::get<int>(key.value));
    return indices;
}

void KeyFrames::refuseChanges(const Scene& scene, const std::vector<std::string>& paths,
                              const std::function<bool(const Scene&)>& isSame, const Sentence& why) {
    constexpr std::size_t maxCombinations = 1024; // a program that depends on more isn't written
    struct Moving {
        const std::string& path;
        std::vector<std::string> values;
    };
    std::vector<Moving> moving;
    for (const auto& [path, param] : params_) {
        const auto isBelow = [&](const std::string& other) {
            return path == other || path.starts_with(other + ".");
        };
        if (std::ranges::any_of(paths, isBelow))
            moving.push_back({path, valuesOf(param)});
    }
    if (moving.empty() || !refused_.path.empty())
        return;
    Scene other = scene;
    std::size_t count = 1; // of the combinations of the values of the first parameters
    for (std::size_t n = 0; n < moving.size(); ++n) {
        count *= moving[n].values.size();
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t before = 1; // this parameter's value changes after so many combinations
            for (std::size_t k = 0; k <= n && i % before == 0; ++k) {
                const std::string& value = moving[k].values[i / before % moving[k].values.size()];
                static_cast<void>(putBetween(other, moving[k].path, value, value, 0));
                before *= moving[k].values.size();
            }
            if (i >= maxCombinations)
                return refuse(moving[n].path, Sentence("a part of the program depends on more than {0} "
                                                       "combinations of key frames",
                                                       maxCombinations));
            if (!isSame(other))
                return refuse(moving[n].path, why);
        }
    }
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

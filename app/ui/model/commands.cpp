#include "app/ui/model/commands.h"

#include "app/ui/model/model_commands.h"
#include "app/ui/model/texture_commands.h"
#include "core/scene/animation.h"
#include "core/scene/drawn_models.h"
#include "core/scene/initial_like.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/param_text.h"
#include "core/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

std::string ownerOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? std::string{} : path.substr(0, dot);
}

/// The target that a texture is shown as first; of one that nobody shows, a picture's.
Target targetOf(const Scene& scene, std::size_t texture) {
    for (const Pass& pass : scene.passes) {
        for (const Unit& unit : pass.units) {
            if (pass.enabled && unit.enabled && unit.texture == static_cast<int>(texture))
                return unit.target;
        }
    }
    return Target::Texture2D;
}

constexpr std::array<std::pair<TexGen Unit::*, Key>, 4> generatedCoordinates{{
    {&Unit::texGenS, keyOf<&Unit::texGenS>},
    {&Unit::texGenT, keyOf<&Unit::texGenT>},
    {&Unit::texGenR, keyOf<&Unit::texGenR>},
    {&Unit::texGenQ, keyOf<&Unit::texGenQ>},
}};

/// The parts that decide nothing: formats of an image that is uploaded with another, coordinates that a
/// target has not, passes and units that are off, GL_COMBINE's state under another mode, coordinates that
/// aren't generated. Their calls are left out.
std::vector<std::string> idleParts(const Scene& scene) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) { // an image is uploaded in one of two ways
        const Compression compression = scene.textures[i].compression;
        const bool compressed = (compression == Compression::Driver || compression == Compression::Cached) &&
                                !isDepth(scene.textures[i].internalFormat);
        const std::string path = elementOf<&Scene::textures>(i) + ".";
        if (compressed) {
            parts.push_back(path + keyOf<&Texture::internalFormat>());
            parts.push_back(path + keyOf<&Texture::border>());
        } else {
            parts.push_back(path + keyOf<&Texture::compressedFormat>());
        }
        if (!isDepth(scene.textures[i].internalFormat)) {
            for (const Key key :
                 {keyOf<&Texture::compareMode>, keyOf<&Texture::compareFunc>, keyOf<&Texture::depthMode>})
                parts.push_back(path + key());
        }
        if (targetOf(scene, i) != Target::Texture3D)
            parts.push_back(path + keyOf<&Texture::wrapR>());
        if (targetOf(scene, i) == Target::Texture1D)
            parts.push_back(path + keyOf<&Texture::wrapT>());
    }
    for (std::size_t m = 0; m < scene.models.size(); ++m)
        parts.push_back(elementOf<&Scene::models>(m)); // which model_commands.h has
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (!scene.passes[p].enabled) {
            parts.push_back(elementOf<&Scene::passes>(p));
            continue;
        }
        if (std::ranges::none_of(scene.passes[p].units, [](const Unit& unit) {
                return unit.enabled && unit.target == Target::CubeMap;
            }))
            parts.push_back(
                fmt::format("{}.{}", elementOf<&Scene::passes>(p), keyOf<&Pass::seamlessCubeMap>()));
        const Fog& fog = scene.passes[p].fog;
        const bool linear = fog.mode == FogMode::Linear;
        for (const auto& [key, decides] : {std::pair<Key, bool>{keyOf<&Fog::mode>, fog.enabled},
                                           {keyOf<&Fog::density>, fog.enabled && !linear},
                                           {keyOf<&Fog::start>, fog.enabled && linear},
                                           {keyOf<&Fog::end>, fog.enabled && linear},
                                           {keyOf<&Fog::color>, fog.enabled}}) {
            if (!decides)
                parts.push_back(
                    fmt::format("{}.{}.{}", elementOf<&Scene::passes>(p), keyOf<&Pass::fog>(), key()));
        }
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& unit = scene.passes[p].units[u];
            const std::string path =
                fmt::format("{}.{}", elementOf<&Scene::passes>(p), elementOf<&Pass::units>(u));
            if (!unit.enabled) {
                parts.push_back(path);
                continue;
            }
            if (unit.envMode != EnvMode::Combine)
                parts.push_back(fmt::format("{}.{}.", path, keyOf<&Unit::combine>()));
            for (std::size_t i = 0; i < unit.matrix.size(); ++i)
                parts.push_back(fmt::format("{}.{}", path, elementOf<&Unit::matrix>(i))); // likewise
            for (const auto& [state, key] : generatedCoordinates) {
                if (!(unit.*state).enabled)
                    parts.push_back(fmt::format("{}.{}.", path, key()));
            }
        }
    }
    return parts;
}

/// Where a block of calls stands in a program.
std::size_t rank(std::string_view owner) {
    constexpr std::array<Key, 6> order{keyOf<&Scene::textures>, keyOf<&Scene::view>,   keyOf<&Scene::light>,
                                       keyOf<&Scene::material>, keyOf<&Scene::passes>, keyOf<&Scene::models>};
    const auto found = std::ranges::find_if(order, [&](Key root) { return owner.starts_with(root()); });
    return static_cast<std::size_t>(found - order.begin());
}

/// Of "textures[3]".
std::size_t indexOf(const std::string& owner) {
    return static_cast<std::size_t>(std::strtoul(owner.c_str() + owner.find('[') + 1, nullptr, 10));
}

void replaceAll(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/// Replaces the words of a call that are keys beside its own: "glAlphaFunc(GL_LESS, alphaRef)".
std::string withSiblings(const Scene& scene, const std::string& call, const std::string& owner) {
    std::string result;
    for (std::size_t i = 0; i < call.size();) {
        std::size_t end = i;
        while (end < call.size() && (std::isalnum(static_cast<unsigned char>(call[end])) || call[end] == '_'))
            ++end;
        if (end == i) {
            result += call[i++];
            continue;
        }
        const std::string word = call.substr(i, end - i);
        const bool isKey = std::islower(static_cast<unsigned char>(word.front())) && !word.starts_with("gl");
        const Result<std::string> value =
            isKey ? getParam(scene, owner.empty() ? word : fmt::format("{}.{}", owner, word))
                  : fail(ErrorCode::NotFound, "");
        result += value ? *value : word;
        i = end;
    }
    return result;
}

/// A call that the camera needs and that no parameter makes alone, before that of `key` or instead of it.
struct CameraCall {
    Key key;
    std::string_view call;
    std::optional<Projection> instead{}; ///< in this projection
};
constexpr std::array cameraCalls{
    CameraCall{keyOf<&View::fieldOfView>, "glMatrixMode(GL_PROJECTION)"},
    CameraCall{keyOf<&View::fieldOfView>, "glLoadIdentity()"},
    CameraCall{keyOf<&View::fieldOfView>,
               "glOrtho(-height * aspect, height * aspect, -height, height, -zFar, zFar)",
               Projection::Orthographic},
    CameraCall{keyOf<&View::distance>, "glMatrixMode(GL_MODELVIEW)"},
    CameraCall{keyOf<&View::distance>, "glLoadIdentity()"},
};

/// In the order in which the matrices are multiplied: what is called last is done to a vertex first.
constexpr std::array<Key, 8> cameraOrder{keyOf<&View::background>,  keyOf<&View::perspectiveHint>,
                                         keyOf<&View::fieldOfView>, keyOf<&View::distance>,
                                         keyOf<&View::roll>,        keyOf<&View::elevation>,
                                         keyOf<&View::azimuth>,     keyOf<&View::target>};

/// The calls of the view's parameters, which come in the order of its panel, as those of a program that sets
/// up the same camera. `aspect` stays: it is the window's.
std::vector<Command> cameraOf(const View& view, std::vector<Command> calls) {
    std::vector<Command> camera{std::move(calls.front())}; // the heading
    for (const Key key : cameraOrder) {
        const std::string path = fmt::format("{}.{}", camera.front().text, key());
        const auto own = std::ranges::find(calls, path, &Command::path);
        if (own == calls.end())
            continue;
        for (const CameraCall& each : cameraCalls) {
            if (each.key != key || (each.instead && *each.instead != view.projection))
                continue;
            if (each.instead)
                own->text = std::string(each.call) + ";";
            else
                camera.push_back({Command::Kind::Call, std::string(each.call) + ";", path, false});
        }
        const auto [near, far] = clipPlanes(view);
        replaceAll(own->text, "zNear", formatNumber(static_cast<float>(near)));
        replaceAll(own->text, "zFar", formatNumber(static_cast<float>(far)));
        replaceAll(own->text, "height", formatNumber(static_cast<float>(halfHeightAtTarget(view))));
        camera.push_back(std::move(*own));
    }
    return camera;
}

/// After the block of each unit, or of its pass: the steps of its texture matrix. After those of a pass:
/// which models it draws, where it names them.
void addSteps(const Scene& scene, std::vector<std::vector<Command>>& blocks) {
    const auto insertAfter = [&](const std::string& owner, std::vector<Command> block) {
        const auto last = std::find_if(blocks.rbegin(), blocks.rend(), [&](const auto& each) {
            return each.front().text.starts_with(owner);
        });
        blocks.insert(last.base(), std::move(block));
    };
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const Pass& pass = scene.passes[p];
        const std::string path = elementOf<&Scene::passes>(p);
        for (std::size_t u = 0; u < maxUnits && pass.enabled; ++u) {
            const std::string unit = fmt::format("{}.{}", path, elementOf<&Pass::units>(u));
            if (!pass.units[u].enabled || pass.units[u].matrix.empty())
                continue;
            const auto call = [&](std::string text) {
                return Command{Command::Kind::Call, std::move(text),
                               fmt::format("{}.{}", unit, keyOf<&Unit::matrix>()), true};
            };
            std::vector<Command> steps;
            for (std::size_t i = 0; i < pass.units[u].matrix.size(); ++i) {
                for (Command& each :
                     stepCommands(pass.units[u].matrix[i],
                                  fmt::format("{}.{}", unit, elementOf<&Unit::matrix>(i)), scene.light)) {
                    steps.push_back(std::move(each));
                    if (steps.size() == 1) // behind the first heading
                        for (const char* text : {"glMatrixMode(GL_TEXTURE);", "glLoadIdentity();"})
                            steps.push_back(call(text));
                }
            }
            steps.insert(steps.begin() + 1, call(fmt::format("glActiveTexture(GL_TEXTURE{});", u)));
            steps.push_back(call("glMatrixMode(GL_MODELVIEW);"));
            insertAfter(unit, std::move(steps));
        }
        std::string names;
        for (const std::size_t model : drawnModels(scene, pass))
            names += (names.empty() ? "" : ", ") + elementOf<&Scene::models>(model);
        if (!pass.models.empty() && !names.empty())
            insertAfter(path, {{Command::Kind::Heading, fmt::format("{} draws {}", path, names), {}, false}});
    }
}

} // namespace

std::vector<Command> commandsOf(const Scene& scene) {
    std::vector<Value> initial;
    forEachParam(initialLike(scene),
                 [&](const std::string&, const ParamRow&, const Value& value) { initial.push_back(value); });
    std::vector<std::vector<Command>> blocks; // each begins with its heading
    std::string owner;
    std::size_t index = 0;
    const std::vector<std::string> idle = idleParts(scene);
    const auto isIdle = [&](const std::string& path) {
        return std::ranges::any_of(idle, [&](const std::string& part) { return path.starts_with(part); });
    };
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        const bool changed = index < initial.size() && value != initial[index];
        ++index;
        if (row.glCall.empty() || isList(row.kind) || isIdle(path))
            return;
        if (const std::string current = ownerOf(path); current != owner || blocks.empty()) {
            owner = current;
            blocks.push_back({{Command::Kind::Heading, owner, {}, false}});
        }
        std::vector<Command>& block = blocks.back();
        const Target target = owner.starts_with(keyOf<&Scene::textures>()) ? targetOf(scene, indexOf(owner))
                                                                           : Target::Texture2D;
        const std::string call = withSiblings(scene, formatCall(row, value, target), owner);
        Command command{Command::Kind::Call, call + ";", path, changed};
        if (block.back().text == command.text) // two parameters of one call
            block.back().changed |= command.changed;
        else
            block.push_back(std::move(command));
    });
    addSteps(scene, blocks);
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        if (isDrawn(scene, m))
            blocks.push_back(modelCommands(scene, m));
    }
    for (std::vector<Command>& block : blocks) {
        const std::string& heading = block.front().text;
        if (heading == keyOf<&Scene::view>())
            block = cameraOf(scene.view, std::move(block));
        else if (heading.starts_with(keyOf<&Scene::textures>()))
            addImageCommands(scene, indexOf(heading), block);
    }
    // As a program does it: first what is set up once, then the camera and the light, then what is drawn.
    std::ranges::stable_sort(blocks, {}, [](const auto& block) { return rank(block.front().text); });
    std::vector<Command> commands;
    for (std::vector<Command>& block : blocks)
        commands.insert(commands.end(), std::make_move_iterator(block.begin()),
                        std::make_move_iterator(block.end()));
    return commands;
}

std::vector<std::string> wrapCall(const std::string& call, std::size_t columns) {
    constexpr std::string_view indent = "    ";
    columns = std::max<std::size_t>(columns, 16);
    // The last place at which `line` may be broken; numbers in braces stay together where they fit.
    const auto breakOf = [&](const std::string& line) {
        std::size_t outside = 0;
        std::size_t inside = 0;
        int depth = 0;
        for (std::size_t i = indent.size(); i < std::min(columns, line.size()); ++i) {
            depth += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
            const bool bracket = line[i] == '(';
            const bool comma = line[i] == ',' && i + 1 < line.size() && line[i + 1] == ' ';
            if (comma && depth > 0)
                inside = i + 1;
            else if (comma || (bracket && outside == 0))
                outside = i + 1;
        }
        return outside > 0 ? outside : inside;
    };
    std::vector<std::string> lines;
    std::string rest = call;
    while (rest.size() > columns) {
        const std::size_t cut = breakOf(rest);
        const std::size_t next = cut == 0 ? std::string::npos : rest.find_first_not_of(' ', cut);
        if (next == std::string::npos)
            break;
        lines.push_back(rest.substr(0, cut));
        rest = std::string(indent) + rest.substr(next);
    }
    lines.push_back(rest);
    return lines;
}

} // namespace texplorer::ui

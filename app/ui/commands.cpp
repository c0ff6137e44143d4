#include "app/ui/commands.h"

#include "core/scene/params.h"

#include <algorithm>
#include <cctype>

namespace texplorer::ui {
namespace {

/// The scene with every parameter at its initial value and every list as long as in `scene`.
Scene initialLike(const Scene& scene) {
    Scene initial;
    initial.models.resize(scene.models.size());
    initial.textures.resize(scene.textures.size());
    initial.passes.resize(scene.passes.size());
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u)
            initial.passes[p].units[u].matrix.resize(scene.passes[p].units[u].matrix.size());
    }
    return initial;
}

std::string ownerOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? std::string{} : path.substr(0, dot);
}

/// "passes[0].units[2]" of a unit that is off, so that its calls are left out.
bool isInDisabledUnit(const Scene& scene, const std::string& path) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const std::string unit = "passes[" + std::to_string(p) + "].units[" + std::to_string(u) + "]";
            if (!scene.passes[p].units[u].enabled && path.starts_with(unit))
                return true;
        }
    }
    return false;
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
        const Result<std::string> value = isKey ? getParam(scene, owner.empty() ? word : owner + "." + word)
                                                : fail(ErrorCode::NotFound, "");
        result += value ? *value : word;
        i = end;
    }
    return result;
}

} // namespace

std::vector<Command> commandsOf(const Scene& scene) {
    std::vector<Value> initial;
    forEachParam(initialLike(scene),
                 [&](const std::string&, const ParamRow&, const Value& value) { initial.push_back(value); });
    std::vector<Command> commands;
    std::string owner;
    std::size_t index = 0;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        const bool changed = index < initial.size() && value != initial[index];
        ++index;
        if (row.glCall.empty() || row.kind == Kind::TexCoordList || isInDisabledUnit(scene, path))
            return;
        if (const std::string current = ownerOf(path); current != owner) {
            owner = current;
            commands.push_back({Command::Kind::Heading, owner, {}, false});
        }
        Command command{Command::Kind::Call, withSiblings(scene, formatCall(row, value), owner) + ";", path,
                        changed};
        if (commands.back().text == command.text) // two parameters of one call
            commands.back().changed |= command.changed;
        else
            commands.push_back(std::move(command));
    });
    return commands;
}

std::vector<std::string> wrapCall(const std::string& call, std::size_t columns) {
    constexpr std::string_view indent = "    ";
    columns = std::max<std::size_t>(columns, 16);
    std::vector<std::string> lines;
    std::string rest = call;
    while (rest.size() > columns) {
        std::size_t cut = rest.rfind(", ", columns - 1);
        cut = cut == std::string::npos || cut <= indent.size() ? std::string::npos : cut + 1;
        if (cut == std::string::npos) {
            const std::size_t bracket = rest.find('(');
            if (bracket == std::string::npos || bracket + 1 >= columns || bracket + 1 == rest.size())
                break;
            cut = bracket + 1;
        }
        lines.push_back(rest.substr(0, cut));
        const std::size_t next = rest.find_first_not_of(' ', cut);
        rest = next == std::string::npos ? std::string{} : std::string(indent) + rest.substr(next);
    }
    lines.push_back(rest);
    return lines;
}

} // namespace texplorer::ui

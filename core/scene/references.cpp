#include "texplorer/scene/references.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace texplorer {
namespace {

/// "textures[12].wrapS" below "textures": 12 and ".wrapS".
struct ElementPath {
    std::size_t index;
    std::string_view rest;
};

std::optional<ElementPath> elementIn(std::string_view path, std::string_view list) {
    if (!path.starts_with(list) || path.size() <= list.size() || path[list.size()] != '[')
        return std::nullopt;
    path.remove_prefix(list.size() + 1);
    std::size_t index = 0;
    const char* end = path.data() + path.size();
    const auto [stop, error] = std::from_chars(path.data(), end, index);
    if (error != std::errc() || stop == end || *stop != ']')
        return std::nullopt;
    return ElementPath{index, path.substr(static_cast<std::size_t>(stop + 1 - path.data()))};
}

int textureAfter(int texture, const Renumbering& number) {
    if (texture < 0)
        return texture;
    const auto now = number(static_cast<std::size_t>(texture));
    return now ? static_cast<int>(*now) : std::max(0, texture - 1);
}

std::vector<int> modelsAfter(const std::vector<int>& models, const Renumbering& number) {
    std::vector<int> now;
    for (const int model : models) {
        if (const auto index = number(static_cast<std::size_t>(model)))
            now.push_back(static_cast<int>(*index));
    }
    return now;
}

/// Numbers with commas between them; nullopt: it is something else.
std::optional<std::vector<int>> parseIndices(std::string_view text) {
    std::vector<int> indices;
    const char* next = text.data();
    const char* end = next + text.size();
    while (next != end) {
        int index = 0;
        const auto [stop, error] = std::from_chars(next, end, index);
        if (error != std::errc() || index < 0 || (stop != end && *stop != ','))
            return std::nullopt;
        indices.push_back(index);
        next = stop == end ? end : stop + 1;
    }
    return indices;
}

void renumberTextures(Scene& scene, const Renumbering& number) {
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units) {
            unit.texture = textureAfter(unit.texture, number);
            unit.enabled = unit.enabled && !scene.textures.empty(); // nothing is left to enable
        }
    }
    for (KeyFrame& key : scene.timeline.keys) {
        const auto indices = parseIndices(key.value);
        if (key.path.starts_with("passes[") && key.path.ends_with("].texture") && indices &&
            indices->size() == 1)
            key.value = std::to_string(textureAfter(indices->front(), number));
    }
}

void renumberModels(Scene& scene, const Renumbering& number) {
    for (Pass& pass : scene.passes) {
        if (pass.models.empty())
            continue;
        pass.models = modelsAfter(pass.models, number);
        pass.enabled = pass.enabled && !pass.models.empty();
    }
    std::erase_if(scene.timeline.keys, [&](KeyFrame& key) {
        const auto indices = parseIndices(key.value);
        if (!key.path.starts_with("passes[") || !key.path.ends_with("].models") || !indices ||
            indices->empty())
            return false;
        const std::vector<int> now = modelsAfter(*indices, number);
        key.value = fmt::format("{}", fmt::join(now, ","));
        return now.empty();
    });
}

} // namespace

Renumbering afterInsert(std::size_t index) {
    return [index](std::size_t each) { return std::optional(each >= index ? each + 1 : each); };
}

Renumbering afterRemove(std::size_t index) {
    return [index](std::size_t each) {
        return each == index ? std::nullopt : std::optional(each > index ? each - 1 : each);
    };
}

Renumbering afterMove(std::size_t from, std::size_t to) {
    return [from, to](std::size_t each) {
        return std::optional(each == from                ? to
                             : from < each && each <= to ? each - 1
                             : to <= each && each < from ? each + 1
                                                         : each);
    };
}

void renumber(Scene& scene, std::string_view list, const Renumbering& number) {
    if (list == "textures")
        renumberTextures(scene, number);
    else if (list == "models")
        renumberModels(scene, number);
    std::erase_if(scene.timeline.keys, [&](KeyFrame& key) {
        const auto element = elementIn(key.path, list);
        if (!element)
            return false;
        const auto now = number(element->index);
        if (now && *now != element->index) // what is written otherwise, "[01]", stays as it is where it may
            key.path = fmt::format("{}[{}]{}", list, *now, element->rest);
        return !now;
    });
}

} // namespace texplorer

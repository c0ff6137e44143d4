#include "app/gles/texel_list.h"

#include "texplorer/glsl/shader_source.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace texplorer::gles {

namespace {

using reference::Level;
using reference::SampledTexture;

/// The faces of a level, or its one image; empty if they don't belong together.
std::vector<const Level*> facesOfLevel(const SampledTexture& texture, int number) {
    std::vector<const Level*> faces;
    for (int face = 0; face < facesOf(texture.target); ++face) {
        const Level* level = texture.level(number, face);
        if (!level || level->texels.size() != texture.level(number)->texels.size() ||
            level->size() != texture.level(number)->size())
            return {};
        faces.push_back(level);
    }
    return faces;
}

void eachLevel(const SampledTexture& texture, auto each) {
    for (int number = 0; number < static_cast<int>(texture.levels.size()); ++number)
        each(number, facesOfLevel(texture, number));
}

std::size_t rowsFor(std::size_t texels) {
    constexpr std::size_t row = glsl::texelsPerRow;
    return std::max<std::size_t>(1, (texels + row - 1) / row);
}

} // namespace

std::size_t rowsOf(const SampledTexture& texture) {
    std::size_t count = 0;
    eachLevel(texture, [&](int /*number*/, const std::vector<const Level*>& faces) {
        for (const Level* face : faces)
            count += face->texels.size();
    });
    return rowsFor(count);
}

TexelList texelList(const SampledTexture& texture) {
    TexelList list;
    list.rows = static_cast<int>(rowsOf(texture));
    std::vector<std::vector<std::int32_t>> bytes; // of each level and face
    eachLevel(texture, [&](int /*number*/, const std::vector<const Level*>& faces) {
        for (const Level* face : faces) {
            if (list.floats)
                return;
            bytes.push_back(face->bytes.empty() ? reference::bytesOf(face->texels) : face->bytes);
            list.floats = bytes.back().empty();
        }
    });
    const std::size_t texelBytes = list.floats ? sizeof(glm::vec4) : sizeof(std::int32_t);
    list.texels.resize(static_cast<std::size_t>(list.rows) * glsl::texelsPerRow * texelBytes);
    std::size_t first = 0;
    std::size_t image = 0;
    const auto append = [&](const auto& texels) {
        const auto from = std::as_bytes(std::span(texels));
        std::memcpy(list.texels.data() + first * texelBytes, from.data(), from.size());
        first += texels.size();
    };
    eachLevel(texture, [&](int /*number*/, const std::vector<const Level*>& faces) {
        std::optional<glm::ivec4>& place = list.levels.emplace_back();
        if (faces.empty())
            return;
        const Level& level = *faces.front();
        const auto extent = [&](int axis) {
            return level.size()[axis] + (axis < axesOf(texture.target) ? 2 * level.border : 0);
        };
        const int slices = texture.target == Target::CubeMap ? facesOf(texture.target) : extent(2);
        place = glm::ivec4(extent(0), extent(1), slices, static_cast<int>(first));
        for (const Level* face : faces) {
            if (list.floats)
                append(face->texels);
            else
                append(bytes[image++]);
        }
    });
    return list;
}

} // namespace texplorer::gles

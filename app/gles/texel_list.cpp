#include "app/gles/texel_list.h"

#include "texplorer/glsl/shader_source.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

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

bool isOutside(const glm::vec4& texel) {
    return !glm::all(glm::greaterThanEqual(texel, glm::vec4(0))) ||
           !glm::all(glm::lessThanEqual(texel, glm::vec4(1)));
}

/// Appends the texels of a face to the list. False: they are no bytes.
bool append(TexelList& list, const Level& face, std::size_t first) {
    const auto copy = [&](const auto& texels) {
        const auto from = std::as_bytes(std::span(texels));
        std::memcpy(list.texels.data() + first * sizeof texels[0], from.data(), from.size());
    };
    if (list.floats) {
        list.isUnclamped = list.isUnclamped || std::ranges::any_of(face.texels, isOutside);
        copy(face.texels);
        return true;
    }
    if (!face.bytes.empty()) {
        copy(face.bytes);
        return true;
    }
    const std::vector<std::int32_t> bytes = reference::bytesOf(face.texels);
    copy(bytes);
    return !bytes.empty();
}

/// Of bytes or floats; nothing if the texels are no bytes.
std::optional<TexelList> listOf(const SampledTexture& texture, bool floats) {
    TexelList list;
    const std::size_t rows = rowsFor(texelCount(texture));
    list.rows = static_cast<int>(rows);
    list.floats = floats;
    list.isUnclamped = isFloat(texture.internalFormat);
    const std::size_t sizeOfTexel = floats ? sizeof(glm::vec4) : sizeof(std::int32_t);
    list.texels.resize(rows * glsl::texelsPerRow * sizeOfTexel);
    std::size_t first = 0;
    bool fits = true;
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
            fits = fits && append(list, *face, first);
            first += face->texels.size();
        }
    });
    std::ranges::fill(std::span(list.texels).subspan(first * sizeOfTexel), std::byte{0}); // of the last row
    return fits ? std::optional(std::move(list)) : std::nullopt;
}

} // namespace

std::size_t texelCount(const SampledTexture& texture) {
    std::size_t count = 0;
    eachLevel(texture, [&](int /*number*/, const std::vector<const Level*>& faces) {
        for (const Level* face : faces)
            count += face->texels.size();
    });
    return count;
}

std::size_t rowsFor(std::size_t texels) {
    constexpr std::size_t row = glsl::texelsPerRow;
    return std::max<std::size_t>(1, (texels + row - 1) / row);
}

TexelList texelList(const SampledTexture& texture) {
    std::optional<TexelList> bytes = listOf(texture, false);
    return bytes ? *std::move(bytes) : listOf(texture, true).value();
}

} // namespace texplorer::gles

#include "texplorer/reference/explain/texel_bytes.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace texplorer::reference {
namespace {

/// The values of more bytes are not readable.
constexpr std::size_t maxValuesShown = 8;

constexpr char packedPixel = 'p';
constexpr char betweenRows = '-';

/// What the memory holds at these bytes: a letter for each number that they are part of.
std::string componentsAt(const MemoryLayout& memory, int width, std::size_t first, std::size_t end) {
    const std::string_view names = componentsOf(memory.pixels.format);
    const TransferTypeFacts& facts = factsOf(memory.pixels.type);
    const std::size_t row = rowStride({memory.pixels, {.alignment = memory.alignment}}, width);
    const auto size = static_cast<std::size_t>(bytesPerPixel(memory.pixels));
    const auto number = static_cast<std::size_t>(facts.bytes);
    std::string letters;
    std::size_t last = 0;
    for (std::size_t at = first; at < end; ++at) {
        const std::size_t inRow = at % row;
        const bool isPixel = inRow < static_cast<std::size_t>(width) * size;
        const std::size_t part = isPixel ? at / row * row + inRow / number * number : at; // where it begins
        if (letters.empty() || part != last)
            letters += !isPixel ? betweenRows : facts.isPacked() ? packedPixel : names[inRow % size / number];
        last = part;
    }
    return letters;
}

std::string spaced(const std::string& letters) {
    return fmt::format("{}", fmt::join(letters, " "));
}

} // namespace

std::optional<TexelBytes> texelBytes(const TextureLevels& levels, Target target, const Tap& tap) {
    const bool isCube = target == Target::CubeMap;
    const auto level = std::ranges::find_if(levels.levels, [&](const TextureLevel& each) {
        return each.number == tap.level && each.face == (isCube ? tap.index.z : 0);
    });
    if (level == levels.levels.end() || !level->memory || !levels.call || (tap.border && levels.border == 0))
        return std::nullopt;
    const Surface& surface = *level->surface;
    const PixelExtent extent{widthOf(surface), heightOf(surface), depthOf(surface)};
    const glm::ivec3 size(extent.width, extent.height, extent.depth);
    const int axes = axesOf(target);
    const glm::ivec3 border(levels.border, axes > 1 ? levels.border : 0, axes > 2 ? levels.border : 0);
    const glm::ivec3 place = glm::ivec3(tap.index.x, tap.index.y, isCube ? 0 : tap.index.z) + border;
    if (glm::any(glm::lessThan(place, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(place, size)))
        return std::nullopt;
    TexelBytes bytes{bytesOf(*levels.call, extent, place.x, place.y, place.z)};
    const std::size_t end =
        std::clamp(bytes.range.end(), bytes.range.first, std::max(bytes.range.first, level->held));
    for (std::size_t at = bytes.range.first; at < end; ++at)
        bytes.values.push_back(std::to_integer<std::uint8_t>((*level->memory)[at]));
    bytes.holds = componentsAt(level->layout, extent.width, bytes.range.first, end);
    bytes.readAs = componentsOf(levels.call->layout.format);
    return bytes;
}

Sentence sentenceOf(const TexelBytes& bytes) {
    const std::string places = bytes.range.count == 1
                                   ? std::to_string(bytes.range.first)
                                   : fmt::format("{}–{}", bytes.range.first, bytes.range.end() - 1);
    const ProperName range{places};
    if (bytes.values.empty())
        return Sentence("memory at byte {0}: beyond its end, 0", range);
    const bool isPacked = bytes.holds.find(packedPixel) != std::string::npos;
    const bool isLong = bytes.values.size() > maxValuesShown;
    const std::string values = isLong ? "…" : fmt::format("{}", fmt::join(bytes.values, " "));
    const std::string held = isPacked ? values : fmt::format("{}, {}", values, spaced(bytes.holds));
    const std::string read = spaced(bytes.readAs);
    const ProperName readAs{read};
    if (bytes.values.size() < bytes.range.count)
        return Sentence("memory at byte {0}: {1}, then 0 beyond its end, read as {2}", range,
                        ProperName{held}, readAs);
    return Sentence("memory at byte {0}: {1}, read as {2}", range, ProperName{held}, readAs);
}

} // namespace texplorer::reference

#include "app/ui/figures/block_flip.h"
#include "app/ui/figures/block_microscope.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/image/convert.h"
#include "texplorer/s3tc/encode.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace texplorer::ui {
namespace {

using SourceKind = BlockSource::Kind;

/// The first level of a face, and the source of its compression if it was compressed here.
struct BaseOfFace {
    const Surface* surface = nullptr;
    const Image* before = nullptr;
};

BaseOfFace baseOfFace(const TextureLevels& levels, int face) {
    auto found = std::ranges::find(levels.levels, face, &TextureLevel::face);
    if (found == levels.levels.end())
        found = levels.levels.begin();
    const auto index = static_cast<std::size_t>(found - levels.levels.begin());
    return {&*found->surface, index < levels.source.size() ? &levels.source[index] : nullptr};
}

/// 4 x 4 texels of the first slice; beyond an edge it is repeated, as encodeBlocks() does.
std::array<BlockColor, 16> texelsAround(const Image& image, int blockX, int blockY) {
    std::array<BlockColor, 16> texels{};
    for (int i = 0; i < 16; ++i) {
        const int x = std::min(4 * blockX + i % 4, image.width - 1);
        const int y = std::min(4 * blockY + i / 4, image.height - 1);
        texels[static_cast<std::size_t>(i)] = rgbaOf(image.format, image.at(x, y).data());
    }
    return texels;
}

BlockBytes compressed(const std::array<BlockColor, 16>& texels, BlockFormat format, EncodeQuality quality) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, 4, 4);
    std::memcpy(image.pixels.data(), texels.data(), image.pixels.size());
    BlockBytes block{};
    if (const Result<BlockImage> made = encodeBlocks(image, format, quality, {}, {}, 1))
        std::ranges::copy(made->blocks, block.begin());
    return block;
}

/// The face and the block of the texel with the greatest weight at the probed pixel; if it was read in a
/// smaller level, the block of the base level at that place.
std::optional<glm::ivec3> probedBlock(const Session& session, const TextureLevels& levels) {
    const reference::UnitExplanation* unit = probedUnit(session);
    if (!unit || unit->sample.taps.empty())
        return std::nullopt;
    const reference::Tap& tap = *std::ranges::max_element(unit->sample.taps, {}, &reference::Tap::weight);
    const int face = unit->target == Target::CubeMap ? tap.index.z : 0;
    const Surface& base = *baseOfFace(levels, face).surface;
    const auto level = std::ranges::find_if(levels.levels, [&](const TextureLevel& each) {
        return each.number == tap.level && each.face == face;
    });
    if (level == levels.levels.end())
        return std::nullopt;
    const auto along = [&](int index, int size, int baseSize) {
        const int inside = std::clamp(index + levels.border, 0, size - 1);
        return static_cast<int>(static_cast<long long>(inside) * baseSize / size) / 4;
    };
    return glm::ivec3(along(tap.index.x, widthOf(*level->surface), widthOf(base)),
                      along(tap.index.y, heightOf(*level->surface), heightOf(base)), face);
}

void takeBlock(BlockMicroscopeState& state, int face) {
    BlockSource& source = state.source;
    const BaseOfFace base = baseOfFace(**source.levels, face);
    const auto* blocks = std::get_if<BlockImage>(base.surface);
    const auto* image = std::get_if<Image>(base.surface);
    source.stored = blocks && blocks->format == state.format;
    source.original.reset();
    if (base.before || image)
        source.original = texelsAround(base.before ? *base.before : *image, source.x, source.y);
    const BlockBytes found = blocks ? blockAt(*blocks, source.x, source.y) : BlockBytes{};
    source.block = source.stored
                       ? found
                       : compressed(source.original ? *source.original : texelsOf(blocks->format, found),
                                    state.format, source.quality);
    source.width = std::min(4, widthOf(*base.surface) - 4 * source.x);
    source.height = std::min(4, heightOf(*base.surface) - 4 * source.y);
    state.block = source.block;
}

void drawExamples(BlockMicroscopeState& state, float width) {
    for (const BlockExample& example : blockExamples) {
        if (ImGui::Button(label(example.label), {width, 0})) {
            state.format = example.format;
            state.block = blockOfHex(example.format, example.hex).value();
        }
        item(fmt::format("block:example {}", example.label), example.help);
    }
}

/// ← → ↓ ↑ to the neighbours, and ↺ to restore the block.
void drawPlace(BlockMicroscopeState& state) {
    BlockSource& source = state.source;
    struct Way {
        const char* sign;
        const char* name;
        const char* help;
        int x, y;
    };
    constexpr std::array ways{Way{"←", "block:left", N_("The previous block along s"), -1, 0},
                              Way{"→", "block:right", N_("The next block along s"), 1, 0},
                              Way{"↓", "block:down", N_("The previous block along t"), 0, -1},
                              Way{"↑", "block:up", N_("The next block along t"), 0, 1}};
    for (const Way& way : ways) {
        const int x = source.x + way.x;
        const int y = source.y + way.y;
        if (way.sign != ways.front().sign)
            ImGui::SameLine(0, 2);
        const bool inside = x >= 0 && y >= 0 && x < source.columns && y < source.rows;
        if (squareButton(way.sign, way.name, way.help, source.kind == SourceKind::Texture && inside)) {
            source.x = x;
            source.y = y;
        }
    }
    ImGui::SameLine(0, 2);
    if (squareButton("↺", "block:again", "Reverts the changes of the block", state.block != source.block))
        state.block = source.block;
}

void drawQuality(BlockSource& source, float width) {
    if (const auto pressed =
            drawSegments(segmentsOf(encodeQualityRows, &EnumRow::label), width,
                         static_cast<std::size_t>(source.quality), [](std::size_t i) {
                             item(fmt::format("block:quality {}", encodeQualityRows.at(i).name),
                                  encodeQualityRows.at(i).help);
                         }))
        source.quality = static_cast<EncodeQuality>(*pressed);
}

/// The texels before compression, small, and the error of the block's texels.
void drawOriginal(const BlockMicroscopeState& state) {
    const BlockSource& source = state.source;
    const float cell = std::floor(ImGui::GetFontSize() * 1.1F);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    for (int i = 0; i < 16; ++i) {
        if (i % 4 >= source.width || i / 4 >= source.height)
            continue;
        const ImVec2 at = low + ImVec2(static_cast<float>(i % 4), static_cast<float>(i / 4)) * cell;
        drawSwatch(at, at + ImVec2(cell - 1, cell - 1), source.original->at(static_cast<std::size_t>(i)));
    }
    ImGui::Dummy({4 * cell, 4 * cell});
    item("block:original", "The texels that the block was compressed from, in the same order");
    const double error = rootMeanSquare(*source.original, texelsOf(state.format, state.block), source.width,
                                        source.height, state.format != BlockFormat::Dxt1);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::BeginGroup();
    dimText("Original");
    dimText("RMS error");
    ImGui::TextUnformatted(fmt::format("{:.2f}", error).c_str());
    ImGui::EndGroup();
    item("block:error",
         "The root mean square of the differences between the original and the block's texels, in 255ths");
}

void giveBack(Session& session, BlockSource& source) {
    giveLevelsBack(workers(session).levels, source);
    source.taken.reset();
}

void follow(Session& session, BlockMicroscopeState& state) {
    BlockSource& source = state.source;
    source.problem = {};
    if (source.kind == SourceKind::Own)
        return giveBack(session, source);
    if (followLevels(workers(session).levels, source, boundLevels(session)))
        source.taken.reset();
    if (!boundTexture(session))
        source.problem = N_("No texture is bound to this unit.");
    if (!source.levels || !source.problem.empty())
        return;
    const TextureLevels& levels = **source.levels;
    int face = 0;
    if (source.kind == SourceKind::Probed) {
        const std::optional<glm::ivec3> block = probedBlock(session, levels);
        if (!block) {
            source.problem = N_("Explain a pixel that reads this texture.");
            return;
        }
        source.x = block->x;
        source.y = block->y;
        face = block->z;
    }
    const Surface& base = *baseOfFace(levels, face).surface;
    if (const auto* blocks = std::get_if<BlockImage>(&base);
        !source.taken && blocks && isS3tc(blocks->format))
        state.format = blocks->format;
    source.columns = (widthOf(base) + 3) / 4;
    source.rows = (heightOf(base) + 3) / 4;
    source.x = std::clamp(source.x, 0, source.columns - 1);
    source.y = std::clamp(source.y, 0, source.rows - 1);
    const BlockSource::Taken now{source.levels.get(), face, source.x, source.y, state.format, source.quality};
    if (source.taken == now)
        return;
    takeBlock(state, face);
    source.taken = now;
}

} // namespace

void followBlockSource(const Session& session, BlockMicroscopeState& state) {
    ask(session, [&state](Session& changed) {
        const std::pair before(state.source.problem, state.source.taken);
        follow(changed, state);
        return before != std::pair(state.source.problem, state.source.taken);
    });
}

float blockSourceWidth() {
    float width = ImGui::GetFontSize() * 8.5F;
    for (const BlockExample& example : blockExamples)
        width = std::max(width, buttonWidth(example.label));
    return std::ceil(width);
}

void drawBlockSource(BlockMicroscopeState& state) {
    BlockSource& source = state.source;
    const float width = ImGui::GetContentRegionAvail().x;
    if (source.kind == SourceKind::Own)
        return drawExamples(state, width);
    if (!source.problem.empty()) {
        dimWrappedText(source.problem);
        noteItem("block:problem");
        return;
    }
    drawPlace(state);
    text(Sentence("Block {0}, {1} of {2} × {3}", source.x, source.y, source.columns, source.rows));
    noteItem("block:place");
    if (source.original)
        drawOriginal(state);
    if (source.stored) {
        dimText("The bytes of the texture");
        noteItem("block:stored");
    } else {
        drawQuality(source, width);
    }
}

} // namespace texplorer::ui

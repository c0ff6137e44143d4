#pragma once

// The state of the microscope, and its columns: the texels, the palette that their indices refer to, the bits
// of the block, and its source.

#include "app/ui/figures/held_levels.h"
#include "texplorer/base/sentence.h"
#include "texplorer/s3tc/block_parts.h"
#include "texplorer/s3tc/encode_quality.h"

#include <array>
#include <optional>
#include <string>

namespace texplorer::ui {

struct BlockExample {
    const char* label;
    BlockFormat format;
    const char* hex;
    const char* help;
};

inline constexpr std::array blockExamples{
    BlockExample{N_("Four colours"), BlockFormat::Dxt1Alpha, "20 FD 30 19 A0 E8 FA 7E",
                 N_("Colour 0 is the larger number: indices 2 and 3 are between the ends.")},
    BlockExample{
        N_("Three and a hole"), BlockFormat::Dxt1Alpha, "30 19 20 FD A5 BD 3E 0A",
        N_("Colour 0 is the smaller number: index 2 is the mean, and index 3 is transparent black.")},
    BlockExample{N_("16 alphas"), BlockFormat::Dxt3, "10 32 54 76 98 BA DC FE 20 FD 30 19 A0 E8 FA 7E",
                 N_("DXT3: each texel has an alpha of 4 bits.")},
    BlockExample{N_("Eight alphas"), BlockFormat::Dxt5, "FF 00 D0 A8 B1 63 CD FA 20 FD 30 19 A0 E8 FA 7E",
                 N_("DXT5 with alpha 0 larger than alpha 1: six alphas between the ends.")},
    BlockExample{N_("Six, 0 and 255"), BlockFormat::Dxt5, "50 B0 86 06 AD 5A B3 E6 20 FD 30 19 A0 E8 FA 7E",
                 N_("DXT5 with alpha 0 smaller than alpha 1: four alphas between the ends, and 0 and 255.")},
};

/// The source of the block: the user's input, or the scene's texture, with its levels.
struct BlockSource : HeldLevels {
    enum class Kind : std::uint8_t { Own, Texture, Probed };
    Kind kind = Kind::Own;
    int x = 0; ///< of the block, along s
    int y = 0; ///< along t
    EncodeQuality quality = EncodeQuality::Best;

    /// The block as it was read.
    struct Taken {
        const PreparedLevels* levels = nullptr;
        int face = 0;
        int x = 0;
        int y = 0;
        BlockFormat format = BlockFormat::Dxt1;
        EncodeQuality quality = EncodeQuality::Best;

        bool operator==(const Taken&) const = default;
    };
    std::optional<Taken> taken{};
    BlockBytes block{};
    bool stored = false; ///< these are the texture's bytes; else they were compressed here
    std::optional<std::array<BlockColor, 16>> original{}; ///< the input of the compression, if known
    int width = 4;                                        ///< how many of the texels are inside the texture
    int height = 4;
    int columns = 1; ///< number of blocks in the texture
    int rows = 1;
};

struct BlockMicroscopeState {
    BlockFormat format = blockExamples.front().format;
    BlockBytes block = blockOfHex(format, blockExamples.front().hex).value();
    std::size_t texel = 0;               ///< the selected one; a click in the palette sets its colour
    std::optional<BlockMark> hovered{};  ///< under the pointer in the previous frame
    std::optional<BlockMark> hovering{}; ///< under the pointer in this frame
    std::string hex{};                   ///< the text being typed
    Sentence hexProblem{};
    BlockSource source{};
};

/// The highlighted parts in this frame, and the block.
struct BlockLook {
    BlockFields fields;
    std::array<BlockColor, 4> colors;
    std::array<std::uint8_t, 16> alphas;
    BlockLinks lit;
};

/// The whole figure.
void drawBlockMicroscope(const Session& session, BlockMicroscopeState& state);

/// For texels of this size; includes the axis to their left.
[[nodiscard]] float blockTexelsWidth(float cell);
void drawBlockTexels(BlockMicroscopeState& state, const BlockLook& look, float cell);

[[nodiscard]] float blockPaletteWidth();
void drawBlockPalette(BlockMicroscopeState& state, const BlockLook& look);

/// `spread`: the distance of the bits, 1 or more.
[[nodiscard]] float blockBitsWidth(BlockFormat format, float spread);
/// The distance that fits into this much more room than a distance of 1 needs.
[[nodiscard]] float blockBitsSpread(BlockFormat format, float more);
/// The width of all bytes in one line.
[[nodiscard]] float blockHexWidth(BlockFormat format);
/// Fills the height `room` if it is enough, and the width of the column.
void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look, float spread, float room);

/// If the source is the texture, reads its block again after a change.
void followBlockSource(const Session& session, BlockMicroscopeState& state);

[[nodiscard]] float blockSourceWidth();
/// The controls of the source, in the column's width.
void drawBlockSource(BlockMicroscopeState& state);

} // namespace texplorer::ui

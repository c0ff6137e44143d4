// The core writes down the numbers of GL without a GL header. These checks prove at compile time that each
// row of each table has the number and the name of the GL macro, and that no row is missing.

#include "texplorer/gl/combine.h"
#include "texplorer/gl/depth_texture.h"
#include "texplorer/gl/environment.h"
#include "texplorer/gl/error.h"
#include "texplorer/gl/fog.h"
#include "texplorer/gl/fragment.h"
#include "texplorer/gl/hint.h"
#include "texplorer/gl/internal_format.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/gl/tex_gen.h"
#include "texplorer/gl/transfer.h"

#include <GL/glew.h>

#include <initializer_list>

namespace texplorer::render {
namespace {

struct Macro {
    std::uint32_t value;
    std::string_view name;
};

template<Enumerated E>
constexpr bool agrees(std::initializer_list<Macro> macros) {
    constexpr std::span<const EnumRow> rows = EnumTable<E>::rows;
    return macros.size() == rows.size() && std::ranges::all_of(rows, [&](const EnumRow& row) {
               return std::ranges::any_of(macros, [&](const Macro& macro) {
                   return macro.value == row.value && macro.name == row.name;
               });
           });
}

// Only a macro can read the name of a macro.
#define TEXPLORER_GL(name)                                                                                   \
    { name, #name }

static_assert(agrees<MagFilter>({TEXPLORER_GL(GL_NEAREST), TEXPLORER_GL(GL_LINEAR)}));
static_assert(
    agrees<MinFilter>({TEXPLORER_GL(GL_NEAREST), TEXPLORER_GL(GL_LINEAR),
                       TEXPLORER_GL(GL_NEAREST_MIPMAP_NEAREST), TEXPLORER_GL(GL_LINEAR_MIPMAP_NEAREST),
                       TEXPLORER_GL(GL_NEAREST_MIPMAP_LINEAR), TEXPLORER_GL(GL_LINEAR_MIPMAP_LINEAR)}));
static_assert(agrees<Wrap>({TEXPLORER_GL(GL_REPEAT), TEXPLORER_GL(GL_MIRRORED_REPEAT),
                            TEXPLORER_GL(GL_CLAMP_TO_EDGE), TEXPLORER_GL(GL_CLAMP_TO_BORDER),
                            TEXPLORER_GL(GL_CLAMP)}));
static_assert(agrees<Target>({TEXPLORER_GL(GL_TEXTURE_1D), TEXPLORER_GL(GL_TEXTURE_2D),
                              TEXPLORER_GL(GL_TEXTURE_3D), TEXPLORER_GL(GL_TEXTURE_CUBE_MAP)}));
static_assert(agrees<CubeFace>(
    {TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_POSITIVE_X), TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_NEGATIVE_X),
     TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_POSITIVE_Y), TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y),
     TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_POSITIVE_Z), TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)}));
static_assert(agrees<TransferFormat>({TEXPLORER_GL(GL_DEPTH_COMPONENT), TEXPLORER_GL(GL_RED),
                                      TEXPLORER_GL(GL_GREEN), TEXPLORER_GL(GL_BLUE), TEXPLORER_GL(GL_ALPHA),
                                      TEXPLORER_GL(GL_RGB), TEXPLORER_GL(GL_RGBA), TEXPLORER_GL(GL_LUMINANCE),
                                      TEXPLORER_GL(GL_LUMINANCE_ALPHA), TEXPLORER_GL(GL_BGR),
                                      TEXPLORER_GL(GL_BGRA)}));
static_assert(agrees<TransferType>(
    {TEXPLORER_GL(GL_BYTE), TEXPLORER_GL(GL_UNSIGNED_BYTE), TEXPLORER_GL(GL_SHORT),
     TEXPLORER_GL(GL_UNSIGNED_SHORT), TEXPLORER_GL(GL_INT), TEXPLORER_GL(GL_UNSIGNED_INT),
     TEXPLORER_GL(GL_FLOAT), TEXPLORER_GL(GL_UNSIGNED_BYTE_3_3_2), TEXPLORER_GL(GL_UNSIGNED_BYTE_2_3_3_REV),
     TEXPLORER_GL(GL_UNSIGNED_SHORT_5_6_5), TEXPLORER_GL(GL_UNSIGNED_SHORT_5_6_5_REV),
     TEXPLORER_GL(GL_UNSIGNED_SHORT_4_4_4_4), TEXPLORER_GL(GL_UNSIGNED_SHORT_4_4_4_4_REV),
     TEXPLORER_GL(GL_UNSIGNED_SHORT_5_5_5_1), TEXPLORER_GL(GL_UNSIGNED_SHORT_1_5_5_5_REV),
     TEXPLORER_GL(GL_UNSIGNED_INT_8_8_8_8), TEXPLORER_GL(GL_UNSIGNED_INT_8_8_8_8_REV),
     TEXPLORER_GL(GL_UNSIGNED_INT_10_10_10_2), TEXPLORER_GL(GL_UNSIGNED_INT_2_10_10_10_REV)}));
static_assert(agrees<EnvMode>({TEXPLORER_GL(GL_REPLACE), TEXPLORER_GL(GL_MODULATE), TEXPLORER_GL(GL_DECAL),
                               TEXPLORER_GL(GL_BLEND), TEXPLORER_GL(GL_ADD), TEXPLORER_GL(GL_COMBINE)}));
static_assert(agrees<CombineRgb>({TEXPLORER_GL(GL_REPLACE), TEXPLORER_GL(GL_MODULATE), TEXPLORER_GL(GL_ADD),
                                  TEXPLORER_GL(GL_ADD_SIGNED), TEXPLORER_GL(GL_INTERPOLATE),
                                  TEXPLORER_GL(GL_SUBTRACT), TEXPLORER_GL(GL_DOT3_RGB),
                                  TEXPLORER_GL(GL_DOT3_RGBA)}));
static_assert(agrees<CombineAlpha>({TEXPLORER_GL(GL_REPLACE), TEXPLORER_GL(GL_MODULATE), TEXPLORER_GL(GL_ADD),
                                    TEXPLORER_GL(GL_ADD_SIGNED), TEXPLORER_GL(GL_INTERPOLATE),
                                    TEXPLORER_GL(GL_SUBTRACT)}));
static_assert(agrees<CombineSource>({TEXPLORER_GL(GL_TEXTURE), TEXPLORER_GL(GL_CONSTANT),
                                     TEXPLORER_GL(GL_PRIMARY_COLOR), TEXPLORER_GL(GL_PREVIOUS),
                                     TEXPLORER_GL(GL_TEXTURE0), TEXPLORER_GL(GL_TEXTURE1),
                                     TEXPLORER_GL(GL_TEXTURE2), TEXPLORER_GL(GL_TEXTURE3)}));
static_assert(agrees<OperandRgb>({TEXPLORER_GL(GL_SRC_COLOR), TEXPLORER_GL(GL_ONE_MINUS_SRC_COLOR),
                                  TEXPLORER_GL(GL_SRC_ALPHA), TEXPLORER_GL(GL_ONE_MINUS_SRC_ALPHA)}));
static_assert(agrees<OperandAlpha>({TEXPLORER_GL(GL_SRC_ALPHA), TEXPLORER_GL(GL_ONE_MINUS_SRC_ALPHA)}));
static_assert(agrees<TexGenMode>({TEXPLORER_GL(GL_EYE_LINEAR), TEXPLORER_GL(GL_OBJECT_LINEAR),
                                  TEXPLORER_GL(GL_SPHERE_MAP), TEXPLORER_GL(GL_NORMAL_MAP),
                                  TEXPLORER_GL(GL_REFLECTION_MAP)}));
static_assert(agrees<BaseFormat>({TEXPLORER_GL(GL_ALPHA), TEXPLORER_GL(GL_LUMINANCE),
                                  TEXPLORER_GL(GL_LUMINANCE_ALPHA), TEXPLORER_GL(GL_INTENSITY),
                                  TEXPLORER_GL(GL_RGB), TEXPLORER_GL(GL_RGBA)}));
static_assert(agrees<InternalFormat>({TEXPLORER_GL(GL_RGBA),
                                      TEXPLORER_GL(GL_RGB),
                                      TEXPLORER_GL(GL_LUMINANCE),
                                      TEXPLORER_GL(GL_LUMINANCE_ALPHA),
                                      TEXPLORER_GL(GL_INTENSITY),
                                      TEXPLORER_GL(GL_ALPHA),
                                      Macro{4, "4"},
                                      Macro{3, "3"},
                                      Macro{2, "2"},
                                      Macro{1, "1"},
                                      TEXPLORER_GL(GL_RGBA8),
                                      TEXPLORER_GL(GL_RGB8),
                                      TEXPLORER_GL(GL_LUMINANCE8),
                                      TEXPLORER_GL(GL_LUMINANCE8_ALPHA8),
                                      TEXPLORER_GL(GL_INTENSITY8),
                                      TEXPLORER_GL(GL_ALPHA8),
                                      TEXPLORER_GL(GL_RGB5_A1),
                                      TEXPLORER_GL(GL_RGBA4),
                                      TEXPLORER_GL(GL_RGBA2),
                                      TEXPLORER_GL(GL_RGB10_A2),
                                      TEXPLORER_GL(GL_RGB5),
                                      TEXPLORER_GL(GL_RGB4),
                                      TEXPLORER_GL(GL_R3_G3_B2),
                                      TEXPLORER_GL(GL_LUMINANCE4),
                                      TEXPLORER_GL(GL_LUMINANCE4_ALPHA4),
                                      TEXPLORER_GL(GL_LUMINANCE6_ALPHA2),
                                      TEXPLORER_GL(GL_LUMINANCE12_ALPHA4),
                                      TEXPLORER_GL(GL_INTENSITY4),
                                      TEXPLORER_GL(GL_ALPHA4),
                                      TEXPLORER_GL(GL_RGBA16),
                                      TEXPLORER_GL(GL_RGBA12),
                                      TEXPLORER_GL(GL_RGB16),
                                      TEXPLORER_GL(GL_RGB12),
                                      TEXPLORER_GL(GL_RGB10),
                                      TEXPLORER_GL(GL_LUMINANCE16),
                                      TEXPLORER_GL(GL_LUMINANCE12),
                                      TEXPLORER_GL(GL_LUMINANCE16_ALPHA16),
                                      TEXPLORER_GL(GL_LUMINANCE12_ALPHA12),
                                      TEXPLORER_GL(GL_INTENSITY16),
                                      TEXPLORER_GL(GL_INTENSITY12),
                                      TEXPLORER_GL(GL_ALPHA16),
                                      TEXPLORER_GL(GL_ALPHA12),
                                      TEXPLORER_GL(GL_SRGB_ALPHA),
                                      TEXPLORER_GL(GL_SRGB),
                                      TEXPLORER_GL(GL_SLUMINANCE_ALPHA),
                                      TEXPLORER_GL(GL_SLUMINANCE),
                                      TEXPLORER_GL(GL_SRGB8_ALPHA8),
                                      TEXPLORER_GL(GL_SRGB8),
                                      TEXPLORER_GL(GL_SLUMINANCE8_ALPHA8),
                                      TEXPLORER_GL(GL_SLUMINANCE8),
                                      TEXPLORER_GL(GL_DEPTH_COMPONENT),
                                      TEXPLORER_GL(GL_DEPTH_COMPONENT16),
                                      TEXPLORER_GL(GL_DEPTH_COMPONENT24),
                                      TEXPLORER_GL(GL_DEPTH_COMPONENT32),
                                      TEXPLORER_GL(GL_RGBA32F_ARB),
                                      TEXPLORER_GL(GL_RGB32F_ARB),
                                      TEXPLORER_GL(GL_LUMINANCE32F_ARB),
                                      TEXPLORER_GL(GL_LUMINANCE_ALPHA32F_ARB),
                                      TEXPLORER_GL(GL_INTENSITY32F_ARB),
                                      TEXPLORER_GL(GL_ALPHA32F_ARB),
                                      TEXPLORER_GL(GL_RGBA16F_ARB),
                                      TEXPLORER_GL(GL_RGB16F_ARB),
                                      TEXPLORER_GL(GL_LUMINANCE16F_ARB),
                                      TEXPLORER_GL(GL_LUMINANCE_ALPHA16F_ARB),
                                      TEXPLORER_GL(GL_INTENSITY16F_ARB),
                                      TEXPLORER_GL(GL_ALPHA16F_ARB),
                                      TEXPLORER_GL(GL_COMPRESSED_RGBA),
                                      TEXPLORER_GL(GL_COMPRESSED_RGB),
                                      TEXPLORER_GL(GL_COMPRESSED_LUMINANCE),
                                      TEXPLORER_GL(GL_COMPRESSED_LUMINANCE_ALPHA),
                                      TEXPLORER_GL(GL_COMPRESSED_INTENSITY),
                                      TEXPLORER_GL(GL_COMPRESSED_ALPHA),
                                      TEXPLORER_GL(GL_COMPRESSED_SRGB_ALPHA),
                                      TEXPLORER_GL(GL_COMPRESSED_SRGB),
                                      TEXPLORER_GL(GL_COMPRESSED_SLUMINANCE_ALPHA),
                                      TEXPLORER_GL(GL_COMPRESSED_SLUMINANCE),
                                      TEXPLORER_GL(GL_BGR),
                                      TEXPLORER_GL(GL_BGRA),
                                      TEXPLORER_GL(GL_UNSIGNED_BYTE),
                                      Macro{0, "0"},
                                      Macro{5, "5"}}));
static_assert(agrees<CompareMode>({TEXPLORER_GL(GL_NONE), TEXPLORER_GL(GL_COMPARE_R_TO_TEXTURE)}));
static_assert(agrees<DepthMode>({TEXPLORER_GL(GL_LUMINANCE), TEXPLORER_GL(GL_INTENSITY),
                                 TEXPLORER_GL(GL_ALPHA)}));
static_assert(agrees<FogMode>({TEXPLORER_GL(GL_LINEAR), TEXPLORER_GL(GL_EXP), TEXPLORER_GL(GL_EXP2)}));
static_assert(agrees<ShadeModel>({TEXPLORER_GL(GL_FLAT), TEXPLORER_GL(GL_SMOOTH)}));
static_assert(agrees<ColorControl>({TEXPLORER_GL(GL_SINGLE_COLOR),
                                    TEXPLORER_GL(GL_SEPARATE_SPECULAR_COLOR)}));
static_assert(agrees<CompareFunc>({TEXPLORER_GL(GL_NEVER), TEXPLORER_GL(GL_LESS), TEXPLORER_GL(GL_EQUAL),
                                   TEXPLORER_GL(GL_LEQUAL), TEXPLORER_GL(GL_GREATER),
                                   TEXPLORER_GL(GL_NOTEQUAL), TEXPLORER_GL(GL_GEQUAL),
                                   TEXPLORER_GL(GL_ALWAYS)}));
static_assert(agrees<BlendFactor>({TEXPLORER_GL(GL_ZERO), TEXPLORER_GL(GL_ONE), TEXPLORER_GL(GL_SRC_COLOR),
                                   TEXPLORER_GL(GL_ONE_MINUS_SRC_COLOR), TEXPLORER_GL(GL_SRC_ALPHA),
                                   TEXPLORER_GL(GL_ONE_MINUS_SRC_ALPHA), TEXPLORER_GL(GL_DST_ALPHA),
                                   TEXPLORER_GL(GL_ONE_MINUS_DST_ALPHA), TEXPLORER_GL(GL_DST_COLOR),
                                   TEXPLORER_GL(GL_ONE_MINUS_DST_COLOR)}));
static_assert(agrees<HintMode>({TEXPLORER_GL(GL_DONT_CARE), TEXPLORER_GL(GL_FASTEST),
                                TEXPLORER_GL(GL_NICEST)}));
static_assert(agrees<GlError>({TEXPLORER_GL(GL_INVALID_ENUM), TEXPLORER_GL(GL_INVALID_VALUE),
                               TEXPLORER_GL(GL_INVALID_OPERATION), TEXPLORER_GL(GL_STACK_OVERFLOW),
                               TEXPLORER_GL(GL_STACK_UNDERFLOW), TEXPLORER_GL(GL_OUT_OF_MEMORY),
                               TEXPLORER_GL(GL_INVALID_FRAMEBUFFER_OPERATION),
                               TEXPLORER_GL(GL_CONTEXT_LOST)}));

#undef TEXPLORER_GL

} // namespace
} // namespace texplorer::render

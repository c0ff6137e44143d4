// Calls of glTexImage that do not fit the program's memory, and rows in another order than OpenGL's.

#include "texplorer/preset/preset_rows.h"

#include <array>

namespace texplorer::preset {
namespace {

constexpr std::string_view uploadGroup = N_("Upload from memory");

/// A pattern on the models, of which OpenGL reads the base alone: a row length fits no smaller level.
void showRead(const PresetTarget& target, Pattern pattern, const Upload& upload) {
    takeGivenCoordinates(target.unit);
    Texture& texture = target.texture;
    showPattern(texture, pattern);
    texture.mipmaps = MipPolicy::None;
    texture.minFilter = MinFilter::Linear;
    texture.magFilter = MagFilter::Linear;
    texture.baseLevel = Texture{}.baseLevel;
    texture.upload = upload;
}

Result<void> slanted(const PresetTarget& target) {
    showRead(target, Pattern::UvTemplate, {.custom = true, .rowLength = 511}); // it has 512 columns
    return {};
}

Result<void> swappedColours(const PresetTarget& target) {
    showRead(target, Pattern::Planet,
             {.custom = true,
              .memory = MemoryRows::Layout,
              .memoryFormat = TransferFormat::Bgr,
              .memoryAlignment = 4,
              .format = TransferFormat::Rgb});
    return {};
}

Result<void> wrongFormat(const PresetTarget& target) {
    showRead(target, Pattern::Planet, {});
    target.texture.internalFormat = InternalFormat::Bgr;
    return {};
}

Result<void> noLevels(const PresetTarget& target) {
    showRead(target, Pattern::Planet, {});
    target.texture.minFilter = Texture{}.minFilter;
    return {};
}

/// A square with t as it counts from the top, or from the bottom.
Model& showUpright(const PresetTarget& target, float bottom) {
    takeGivenCoordinates(target.unit);
    target.unit.envMode = EnvMode::Replace;
    Model& square = showSquare(target.scene);
    square.texCoords[target.place.unit] = {
        {0, bottom, 0, 1}, {1, bottom, 0, 1}, {1, 1 - bottom, 0, 1}, {0, 1 - bottom, 0, 1}};
    return square;
}

Result<void> upsideDown(const PresetTarget& target) {
    showPatternUnlessOwn(target.texture, Pattern::Tree);
    showUpright(target, 1);
    return {};
}

Result<void> upsideDownCure(const PresetTarget& target) {
    showUpright(target, 0);
    return {};
}

constexpr std::array uploadRows{
    Preset{"slanted", uploadGroup, N_("Slanted picture"),
           N_("GL_UNPACK_ROW_LENGTH is one pixel less than the rows that the program holds."),
           N_("The picture leans: OpenGL begins each row one pixel earlier than the row before. A wrong "
              "GL_UNPACK_ALIGNMENT does the same, and shifts the colours as well."),
           slanted},
    Preset{"swapped-colours", uploadGroup, N_("Swapped colours"),
           N_("The memory holds blue, green, red, as in BMP files, but glTexImage2D is told GL_RGB."),
           N_("The seas are brown and the highlands blue: red and blue have changed places. Told GL_BGR, "
              "OpenGL reads them right."),
           swappedColours},
    Preset{"wrong-format", uploadGroup, N_("Wrong internal format"),
           N_("The argument internalFormat is GL_BGR, which is an order of components in memory."),
           N_("Nothing but the colour of the models: OpenGL answers GL_INVALID_VALUE, and the texture has no "
              "image. With GL_RGB it has one."),
           wrongFormat},
    Preset{
        "no-levels", uploadGroup, N_("White without mipmaps"),
        N_("One image, and GL_TEXTURE_MIN_FILTER as it is in a new texture: GL_NEAREST_MIPMAP_LINEAR."),
        N_("Nothing but the colour of the models: the filter asks for smaller levels, and without them the "
           "texture is incomplete."),
        noLevels},
    Preset{"upside-down", uploadGroup, N_("Upside-down picture"),
           N_("A square whose t counts from the top, as rows do in most files and t does in Direct3D."),
           N_("The picture stands on its head: in OpenGL t is 0 at the first row of glTexImage2D, and 1 at "
              "the last one, which should be the top."),
           upsideDown},
    Preset{
        "upside-down-cure", uploadGroup, N_("Upside-down picture, cured"),
        N_("1 - t for every vertex, so that t is 0 at the bottom."),
        N_("The picture is upright. Programs change t, or reverse the rows of the file when they load it."),
        upsideDownCure, true},
};

} // namespace

std::span<const Preset> uploadPresets() {
    return uploadRows;
}

} // namespace texplorer::preset

// Calls of glTexImage that do not fit the program's memory.

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
};

} // namespace

std::span<const Preset> uploadPresets() {
    return uploadRows;
}

} // namespace texplorer::preset

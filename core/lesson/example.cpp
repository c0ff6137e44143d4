#include "texplorer/lesson/example.h"

#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/nearest_name.h"

#include <algorithm>
#include <array>
#include <string>

namespace texplorer {
namespace {

constexpr std::array exampleRows{
    Example{"cube.json", N_("Textured cube"), N_("One image on six faces: coordinates, filters, mipmaps.")},
    Example{"checker.json", N_("Checkerboard, near and slanted"),
            N_("The same 64 × 64 texels on a square that faces the viewer and on a slanted one.")},
    Example{"texbind.json", N_("Two textures"),
            N_("Two texture objects: each pass binds one and draws one of the two squares.")},
    Example{"quadrics.json", N_("Quadrics"),
            N_("Sphere, cylinder, disk and partial disk with GLU's texture coordinates.")},
    Example{"earth.json", N_("Planet"), N_("An image around a sphere that spins about a tilted axis.")},
    Example{"line.json", N_("Line texture"), N_("A one-dimensional texture along a line.")},
    Example{"spiral.json", N_("Spiral line"),
            N_("A one-dimensional texture along a line strip: s grows with its "
               "length.")},
    Example{"marble.json", N_("Marble block"),
            N_("A three-dimensional texture. The block looks carved out of it.")},
    Example{"contours.json", N_("Contour lines"),
            N_("Generated coordinates: s is the height of a vertex, so equal heights have the same colour.")},
    Example{"teapot.json", N_("Teapot"),
            N_("M. Newell's teapot: the image goes once around each of its four "
               "parts.")},
    Example{
        "internal-formats.json", N_("Few bits, and sRGB"),
        N_("A smooth image with 8 and with 4 bits a component; below as sRGB, and with 3, 3 and 2 bits.")},
    Example{
        "packed-pixels.json", N_("Packed pixels"),
        N_("One image in four layouts of memory: 5 6 5, 4 4 4 4 and 3 3 2 bits, and bytes with blue first.")},
    Example{"floats.json", N_("Floats"),
            N_("An image scaled by 4 at its upload and dimmed to a quarter: left limited, right kept in floats.")},
    Example{"texsub.json", N_("Replaced texels"),
            N_("glTexSubImage2D puts 16 × 16 red texels into the checkerboard after its upload.")},
    Example{"levels.json", N_("An image for each level"),
            N_("Mip levels from separate images, which shows where each level is sampled.")},
    Example{"environment.json", N_("Environment map"), N_("GL_SPHERE_MAP: the surface reflects an image.")},
    Example{"seamless.json", N_("Seamless cube map"),
            N_("A cube map with 4 × 4 texels a face, filtered face by face and across the edges.")},
    Example{"fog.json", N_("Fog"), N_("Far objects, and their aliasing, fade to the background's colour.")},
    Example{"slide-projector.json", N_("Slide projector"),
            N_("An image projected over the whole scene: coordinates in eye space, and a projector.")},
    Example{"shadow-map.json", N_("Shadow map"),
            N_("A depth texture of the light's view, compared with the distance of each point.")},
    Example{
        "mirror.json", N_("Mirror"),
        N_("A pass draws the mirrored pyramid in a picture, and the mirror shows it at the same pixels.")},
    Example{
        "radial-blur.json", N_("Radial blur"),
        N_("A small picture of the ring, copied and drawn over it 25 times, each time larger and fainter.")},
    Example{"feedback.json", N_("Picture in a picture"),
            N_("The cube shows the picture of the frame before, which shows the cube.")},
    Example{"nehe-bumps-1-unit.json", N_("Embossed bumps, one unit"),
            N_("A height map minus its copy, moved towards the light, in three passes. Step through them.")},
    Example{"nehe-bumps-2-units.json", N_("Embossed bumps, two units"),
            N_("The same with two texture units and one pass less.")},
    Example{"nehe-no-bumps.json", N_("Embossed bumps, off"), N_("The lit image without the bumps.")},
};

/// "there is no example "cub"; did you mean "cube"?"
Sentence absentText(std::string_view file) {
    const auto stem = [](std::string_view name) { return name.substr(0, name.rfind(".json")); };
    std::vector<std::string_view> names;
    for (const Example& each : exampleRows)
        names.push_back(stem(each.file));
    const std::string_view near = nearestName(stem(file), names);
    const std::string name = inQuotes(stem(file));
    return near.empty() ? Sentence("there is no example {0}", ProperName{name})
                        : Sentence("there is no example {0}; did you mean {1}?", ProperName{name},
                                   ProperName{inQuotes(near)});
}

} // namespace

std::span<const Example> examples() {
    return exampleRows;
}

Result<Scene> exampleScene(std::string_view file) {
    const auto found = std::ranges::find(exampleFiles(), file, &ExampleFile::name);
    if (found == exampleFiles().end())
        return fail(ErrorCode::NotFound, absentText(file));
    return parseScene(found->text);
}

} // namespace texplorer

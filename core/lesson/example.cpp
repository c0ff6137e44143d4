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
    Example{"cube.json", "Textured cube", "One image on six faces: coordinates, filters, mipmaps."},
    Example{"checker.json", "Checkerboard, near and slanted",
            "The same 64 × 64 texels on a square that faces the viewer and on a slanted one."},
    Example{"texbind.json", "Two textures",
            "Two texture objects: each pass binds one and draws one of the two squares."},
    Example{"quadrics.json", "Quadrics",
            "Sphere, cylinder, disk and partial disk with GLU's texture coordinates."},
    Example{"earth.json", "Planet", "An image around a sphere that spins about a tilted axis."},
    Example{"line.json", "Line texture", "A one-dimensional texture along a line."},
    Example{"spiral.json", "Spiral line",
            "A one-dimensional texture along a line strip: s grows with its "
            "length."},
    Example{"marble.json", "Marble block", "A three-dimensional texture. The block looks carved out of it."},
    Example{"contours.json", "Contour lines",
            "Generated coordinates: s is the height of a vertex, so equal heights have the same colour."},
    Example{"teapot.json", "Teapot",
            "M. Newell's teapot: the image goes once around each of its four "
            "parts."},
    Example{"internal-formats.json", "Few bits, and sRGB",
            "A smooth image with 8 and with 4 bits a component; below as sRGB, and with 3, 3 and 2 bits."},
    Example{"levels.json", "An image for each level",
            "Mip levels from separate images, which shows where each level is sampled."},
    Example{"environment.json", "Environment map", "GL_SPHERE_MAP: the surface reflects an image."},
    Example{"seamless.json", "Seamless cube map",
            "A cube map with 4 × 4 texels a face, filtered face by face and across the edges."},
    Example{"fog.json", "Fog", "Far objects, and their aliasing, fade to the background's colour."},
    Example{"slide-projector.json", "Slide projector",
            "An image projected over the whole scene: coordinates in eye space, and a projector."},
    Example{"shadow-map.json", "Shadow map",
            "A depth texture of the light's view, compared with the distance of each point."},
    Example{"nehe-bumps-1-unit.json", "Embossed bumps, one unit",
            "A height map minus its copy, moved towards the light, in three passes. Step through them."},
    Example{"nehe-bumps-2-units.json", "Embossed bumps, two units",
            "The same with two texture units and one pass less."},
    Example{"nehe-no-bumps.json", "Embossed bumps, off", "The lit image without the bumps."},
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

#include "tests/support/flat_scene.h"

#include <algorithm>
#include <cassert>

namespace texplorer::test {

Scene flatScene() {
    Scene scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.fieldOfView = 90; // at distance 1 that is a height of 2, from -1 to 1
    scene.view.distance = 1;
    Model quad;
    quad.shape = Shape::Quad;
    scene.models = {quad};
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = "image";
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    scene.textures = {texture};
    return scene;
}

Scene texturedScene() {
    Scene scene = flatScene();
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    return scene;
}

TexCoords quadCoords(glm::vec4 lowerLeft, glm::vec4 upperRight) {
    TexCoords coords;
    for (const Vertex& vertex : makeMesh({Shape::Quad}).vertices) {
        const glm::vec4 corner = lowerLeft;
        const glm::vec4 across = upperRight - lowerLeft;
        coords.push_back(
            corner + across * glm::vec4(vertex.position.x > 0 ? 1 : 0, vertex.position.y > 0 ? 1 : 0, 0, 0));
    }
    return coords;
}

Image rgbaImage(int width, int height, int depth, std::initializer_list<Texel> texels) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height, depth);
    assert(image.pixels.size() == 4 * texels.size());
    auto out = image.pixels.begin();
    for (const Texel& texel : texels)
        out = std::ranges::transform(texel, out, [](int value) { return static_cast<std::byte>(value); }).out;
    return image;
}

Image plainImage(int width, int height, Texel texel) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(texel[i % 4]);
    return image;
}

} // namespace texplorer::test

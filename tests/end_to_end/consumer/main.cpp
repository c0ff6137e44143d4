// Another project that uses the installed library: consumer IN.dds OUT.dds OUT.png
// Turns the texture upside down, makes its mip levels, and shows it texel for pixel.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <texplorer/codec/texture_file.h>
#include <texplorer/reference/draw.h>
#include <texplorer/reference/probe.h>
#include <texplorer/reference/sampling/sampler.h>
#include <texplorer/s3tc/texture_flip.h>
#include <texplorer/s3tc/texture_mips.h>
#include <texplorer/scene/params/json.h>
#include <texplorer/texture/texture_levels.h>
#include <texplorer/version.h>
#include <thread>

namespace {

using namespace texplorer;

template<class T>
T orEnd(Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "consumer: %s\n", describe(result.error()).english().c_str());
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

/// A square that fills the picture.
constexpr const char* sceneText = R"({
    "version": 1,
    "view": {"projection": "orthographic", "fieldOfView": 90, "distance": 1, "azimuth": 0, "elevation": 0},
    "models": [{"shape": "quad"}],
    "textures": [{"source": "file", "file": "it", "minFilter": "GL_NEAREST", "magFilter": "GL_NEAREST"}],
    "passes": [{"units": [{"enabled": true, "envMode": "GL_REPLACE"}]}]
})";

} // namespace

int main(int count, char** words) {
    if (count != 4)
        return 2;
    TextureImage texture = orEnd(loadTexture(words[1]));
    orEnd(flip(texture));
    orEnd(buildMips(texture));
    orEnd(saveTexture(texture, words[2]));
    const int width = widthOf(texture.surface(0, 0));
    const int height = heightOf(texture.surface(0, 0));

    const Scene scene = orEnd(parseScene(sceneText));
    const TextureLevels levels = orEnd(prepareLevels(scene.textures[0], texture));
    std::vector<Sentence> notes;
    const auto sampled =
        orEnd(reference::sampledTexture(scene.textures[0], levels, Target::Texture2D, notes));
    const glm::vec4 color = reference::sample(
        sampled, {0.5F / static_cast<float>(width), 0.5F / static_cast<float>(height), 0}, {});

    ImageSource images;
    images.put("it", texture);
    const auto explained = orEnd(reference::probe({scene, images, 0, width, height}, {0, 0}));
    Frame drawn[2];
    const auto draw = [&](Frame& into) {
        into = orEnd(reference::drawReference({scene, images, 0, width, height}));
    };
    std::thread other(draw, std::ref(drawn[1]));
    draw(drawn[0]);
    other.join();
    if (drawn[0].image != drawn[1].image)
        return 3;
    orEnd(saveTexture(textureOf(std::move(drawn[0].image), {}), words[3]));

    std::printf("%s, levels %d, sample %.0f %.0f %.0f, probe %d %d %d\n", TEXPLORER_VERSION_TEXT,
                texture.levels, std::round(color.r * 255), std::round(color.g * 255),
                std::round(color.b * 255), explained.bytes[0], explained.bytes[1], explained.bytes[2]);
    return 0;
}

#pragma once

// Scenes with a mistake for every finding of the diagnosis.

#include "texplorer/diagnosis/diagnosis.h"

#include <algorithm>
#include <iosfwd>
#include <span>
#include <vector>

namespace texplorer::test {

/// What is diagnosed.
struct Subject {
    Scene scene = defaultScene();
    ImageSource images;
    DriverFacts driver;

    Texture& texture() { return scene.textures[0]; }
    Pass& pass() { return scene.passes[0]; }
    Unit& unit(std::size_t index = 0) { return scene.passes[0].units[index]; }
    Combine& combine() {
        unit().envMode = EnvMode::Combine;
        return unit().combine;
    }
    void showFile(int width, int height, int levels = 1) {
        texture().source = SourceKind::File;
        texture().file = "image.png";
        TextureImage image;
        image.levels = levels;
        for (int level = 0; level < levels; ++level)
            image.surfaces.emplace_back(Image::uninitialised(PixelFormat::Rgba8, std::max(1, width >> level),
                                                             std::max(1, height >> level)));
        images.put("image.png", std::move(image));
    }
    /// A gradient from black at the bottom left to white at the top right, or squares of both.
    void showGreys(bool smooth) {
        texture().source = SourceKind::File;
        texture().file = "greys.png";
        Image image = Image::uninitialised(PixelFormat::Luminance8, 128, 128);
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x)
                image.at(x, y)[0] = static_cast<std::byte>(smooth                     ? x + y
                                                           : (x / 8 + y / 8) % 2 == 0 ? 0
                                                                                      : 255);
        }
        images.put("greys.png", std::move(image));
    }
    [[nodiscard]] std::vector<Finding> findings() const { return diagnose(scene, images, driver); }
};

/// A mistake in a scene, its finding and where it is shown, and what fixes it.
struct Mistake {
    const char* name;
    const char* rule;
    Severity severity;
    const char* path;
    const char* words; ///< part of the sentence
    void (*spoil)(Subject& s);
    void (*correct)(Subject& s) = nullptr; ///< nullptr: the finding's fixes do
};

void PrintTo(const Mistake& mistake, std::ostream* out);

/// All of them, each with another name.
[[nodiscard]] std::vector<Mistake> mistakes();

/// The light's shadows, as they should be.
void castShadows(Subject& s);

// The parts of mistakes().
[[nodiscard]] std::span<const Mistake> textureMistakes();
[[nodiscard]] std::span<const Mistake> levelMistakes();
[[nodiscard]] std::span<const Mistake> uploadMistakes();
[[nodiscard]] std::span<const Mistake> formatMistakes();
[[nodiscard]] std::span<const Mistake> settingMistakes();
[[nodiscard]] std::span<const Mistake> unitMistakes();
[[nodiscard]] std::span<const Mistake> passMistakes();
[[nodiscard]] std::span<const Mistake> vertexMistakes();
[[nodiscard]] std::span<const Mistake> depthMistakes();
[[nodiscard]] std::span<const Mistake> pictureMistakes();

} // namespace texplorer::test

#include "tests/random/odd_files.h"

#include "tests/support/sample_jpegs.h"
#include "tests/support/sample_textures.h"
#include "texplorer/image/convert.h"
#include "texplorer/image/patterns/pattern.h"

#include <random>

namespace texplorer::random {

namespace {

Image noise(int width, int height, int depth = 1) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height, depth);
    std::mt19937 random(static_cast<unsigned>(width * 31 + height)); // NOLINT: the same bytes each time
    for (std::byte& each : image.pixels)
        each = static_cast<std::byte>(random() >> 24);
    return image;
}

/// Long and thin, in the shapes that a cube's faces are cut from, and chains of which the last levels are
/// missing.
std::vector<TextureImage> oddTextures() {
    std::vector<TextureImage> textures;
    for (const auto& [width, height] :
         {std::pair{300, 1}, {1, 300}, {96, 16}, {16, 96}, {64, 48}, {48, 64}, {127, 129}, {256, 256}})
        textures.push_back(textureOf(noise(width, height), {}));
    for (const int faces : {1, 6}) {
        TextureImage few;
        few.faces = faces;
        few.levels = 2; // of six
        few.alpha = AlphaMeaning::Straight;
        for (int face = 0; face < faces; ++face)
            for (const int extent : {32, 16})
                few.surfaces.emplace_back(noise(extent, extent));
        textures.push_back(std::move(few));
    }
    return textures;
}

Bytes cut(const Bytes& file, std::mt19937& random) {
    return {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(random() % file.size())};
}

Bytes changed(Bytes file, std::mt19937& random) {
    for (int i = 0; i < 3; ++i)
        file[random() % file.size()] ^= static_cast<std::byte>(1U << (random() % 8));
    return file;
}

std::vector<Bytes> filesOf(const CodecRow& row) {
    if (!row.encode)
        return test::sampleJpegs();
    std::vector<Bytes> files = test::sampleFiles(row);
    for (const TextureImage& texture : oddTextures())
        if (Result<Bytes> file = row.encode(texture, {}))
            files.push_back(std::move(*file));
    return files;
}

} // namespace

std::vector<OddFile> oddFiles() {
    std::vector<OddFile> all;
    for (const CodecRow& row : codecRows()) {
        std::mt19937 random(1); // NOLINT: the same damage each time
        const std::string extension = extensionsOf(row).front();
        const std::string name = extension.substr(1) + "-";
        int number = 0;
        for (const Bytes& file : filesOf(row)) {
            const std::string numbered = name + std::to_string(number++);
            all.push_back({numbered + extension, file});
            if (number % 4 == 0) {
                all.push_back({numbered + "-cut" + extension, cut(file, random)});
                all.push_back({numbered + "-changed" + extension, changed(file, random)});
            }
        }
    }
    all.push_back({"empty.bmp", {}});
    all.push_back({"other.png", all.front().bytes}); // a name that says something else than the content
    return all;
}

std::vector<std::string> namesOf(const std::vector<OddFile>& files) {
    std::vector<std::string> names{"nowhere.bmp", ".", "/dev/null", ""};
    for (const OddFile& file : files)
        names.push_back(file.name);
    return names;
}

} // namespace texplorer::random

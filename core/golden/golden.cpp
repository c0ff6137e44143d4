#include "texplorer/golden/golden.h"

#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/texture_file.h"
#include "texplorer/compare/comparison.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace texplorer {
namespace {

namespace fs = std::filesystem;

/// What a failure leaves.
struct Leaving {
    std::string_view label;
    fs::path path;
    const Image* picture; ///< empty: there is none
};

Result<void> checkFramebuffer(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.depth != 1)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a framebuffer with pixels, found one of {0} × {1} × {2}", image.width,
                             image.height, image.depth));
    if (image.pixels.size() != image.byteCount())
        return fail(ErrorCode::OutOfRange,
                    Sentence("a framebuffer of {0} × {1} pixels needs {2}, found {3}", image.width,
                             image.height, Sentence::plural("{0} byte", "{0} bytes", image.byteCount()),
                             image.pixels.size()));
    return {};
}

Result<Image> loadPicture(const fs::path& path) {
    Result<TextureImage> file = loadTexture(path);
    if (!file)
        return fail(file.error());
    const Surface& base = file->surface(0, 0);
    if (file->faces > 1 || depthOf(base) > 1)
        return fail(ErrorCode::Unsupported,
                    Sentence("expected one picture, found {0}",
                             file->faces > 1 ? Sentence::plural("{0} face", "{0} faces", file->faces)
                                             : Sentence::plural("{0} slice", "{0} slices", depthOf(base))),
                    inFile(path.string()));
    return uprightImage(*std::move(file));
}

Result<void> savePicture(const Image& picture, const fs::path& path) {
    std::error_code error;
    if (path.has_parent_path())
        fs::create_directories(path.parent_path(), error);
    if (error)
        return fail(ErrorCode::Unwritable, Sentence("the folder can't be made: {0}", error.message()),
                    inFile(path.parent_path().string()));
    return saveTexture(textureOf(picture, {}), path);
}

Result<GoldenCheck> written(const Image& framebuffer, const fs::path& golden) {
    if (const Result<void> saved = savePicture(framebuffer, golden); !saved)
        return fail(saved.error());
    return GoldenCheck{
        .alike = true, .written = true, .message = "the golden was written: " + printable(golden.string())};
}

/// A failure of that sentence with its pictures.
Result<GoldenCheck> failed(std::string sentence, const fs::path& golden, std::span<const Leaving> leavings) {
    GoldenCheck check{.message = std::move(sentence)};
    check.message += "\n  golden:      " + printable(golden.string());
    for (const Leaving& each : leavings) {
        if (each.picture->empty())
            continue;
        const Result<void> saved = savePicture(*each.picture, each.path);
        check.message += fmt::format("\n  {:<13}{}", fmt::format("{}:", each.label),
                                     saved ? printable(each.path.string())
                                           : "not written: " + printable(describe(saved.error())));
    }
    check.message +=
        "\n"
        "  If the new one is correct, run this test with TEXPLORER_UPDATE_GOLDENS=1 to write the golden.";
    return check;
}

} // namespace

bool goldensAreUpdated() {
    const char* value =
        std::getenv("TEXPLORER_UPDATE_GOLDENS"); // NOLINT(concurrency-mt-unsafe): it is not changed
    return value != nullptr && *value != '\0' && std::string_view(value) != "0";
}

Result<GoldenCheck> checkGolden(const Image& framebuffer, const fs::path& golden,
                                const GoldenOptions& options) {
    if (const Result<void> checked = checkFramebuffer(framebuffer); !checked)
        return fail(checked.error());

    std::error_code ignored;
    const fs::path folder =
        fs::absolute(options.failures.empty() ? "." : options.failures, ignored).lexically_normal();
    const auto left = [&](const char* what) {
        fs::path name = golden.stem();
        name += what;
        return folder / name;
    };
    Image expected;
    Comparison comparison;
    const std::array leavings{Leaving{"actual", left("-actual.png"), &framebuffer},
                              Leaving{"expected", left("-expected.png"), &expected},
                              Leaving{"difference", left("-difference.png"), &comparison.map}};
    for (const Leaving& each : leavings)
        fs::remove(each.path, ignored);

    Result<Image> stored = loadPicture(golden);
    if (!stored) {
        if (options.update)
            return written(framebuffer, golden);
        if (stored.error().code != ErrorCode::NotFound)
            return fail(stored.error());
        return failed("there is no golden", golden, leavings);
    }
    expected = *std::move(stored);
    Image mask;
    if (!options.mask.empty()) {
        Result<Image> loaded = loadPicture(options.mask);
        if (!loaded)
            return fail(loaded.error());
        mask = *std::move(loaded);
    }
    Result<Comparison> compared =
        comparePictures(expected, framebuffer, options.criterion, options.mask.empty() ? nullptr : &mask);
    if (!compared)
        return fail(compared.error());
    comparison = *std::move(compared);
    if (comparison.alike)
        return GoldenCheck{.alike = true, .message = std::move(comparison.sentence)};
    if (options.update)
        return written(framebuffer, golden);
    return failed(comparison.sentence, golden, leavings);
}

Result<GoldenCheck> checkGolden(int width, int height, std::span<const std::byte> rgba,
                                const fs::path& golden, const GoldenOptions& options) {
    Image framebuffer{PixelFormat::Rgba8, width, height, 1, {}};
    if (width < 1 || height < 1 || rgba.size() != framebuffer.byteCount())
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a framebuffer of {0} × {1} pixels with 4 bytes each, found {2}", width,
                             height, Sentence::plural("{0} byte", "{0} bytes", rgba.size())));
    framebuffer.pixels.assign(rgba.begin(), rgba.end());
    if (options.rowsTopFirst)
        flipVertically(framebuffer);
    return checkGolden(framebuffer, golden, options);
}

} // namespace texplorer

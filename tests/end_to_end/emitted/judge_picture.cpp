// judge_picture SCENE FOLDER [SECONDS PICTURE EXPECTED]...: whether pictures that SwiftShader drew of a scene
// at these times are what OpenGL allows, by the rules by which "texshot test" holds one against the
// reference. FOLDER has the images that the scene names. For each it prints the rule, how many pixels there
// are, how many are over its bound, and how many of them no freedom of a driver explains, as a line of JSON;
// where there are any, EXPECTED is what the reference draws. Exit status: 0 it has judged, 2 it can't.
//
// What OpenGL leaves to a driver, SwiftShader decides otherwise than Mesa: it snaps corners to less, its
// switch-over is always at 0, and it probes along a line under anisotropy. The reference is told so
// (requestFor), and what remains is held to the same rules. Its lambda lies within what the rules grant a
// driver's arithmetic (lambda_range.h): from one derivative for 2 x 2 pixels, of log2(rho) at most 0.0215 too
// little, which was measured at 81 places from 0 to 5.

#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/registry.h"
#include "texplorer/conform/judge.h"
#include "texplorer/conform/lambda_range.h"
#include "texplorer/files/file_io.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/suite/rule_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>

namespace texplorer {
namespace {

constexpr int unable = 2;

/// GL_SUBPIXEL_BITS of SwiftShader, as its pages say: the least that OpenGL allows (table 6.35). Everything
/// that is interpolated follows corners that are snapped to a sixteenth of a pixel.
constexpr int cornerBits = 4;

int complain(const Error& error) {
    fmt::print(stderr, "judge_picture: {}\n", describe(error));
    return unable;
}

/// No screen shows alpha.
void makeOpaque(Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        image.pixels[i] = std::byte{255};
}

/// The reference at a time and in a size.
class Reference : public conform::Explainer {
public:
    Reference(ImageSource images, double seconds, int width, int height)
        : images_(std::move(images))
        , seconds_(seconds)
        , width_(width)
        , height_(height) {}

    Result<Frame> drawBy(const Scene& scene, reference::RhoMethod rho) override {
        Result<Frame> frame = renderer_.draw(requestFor(scene, rho), {.threads = 1});
        if (frame)
            makeOpaque(frame->image);
        return frame;
    }
    Result<std::vector<reference::PixelBytes>> overLambda(const Scene& scene, reference::PixelPlace pixel,
                                                          conform::RhoMethods methods) override {
        auto colors = conform::colorsOverLambda(renderer_, requestFor(scene, methods.front()), pixel, methods,
                                                {.threads = 1});
        if (colors)
            std::ranges::for_each(*colors, [](reference::PixelBytes& each) { each[3] = 255; });
        return colors;
    }
    const ImageSource& images() const override { return images_; }

private:
    [[nodiscard]] reference::DrawRequest requestFor(const Scene& scene, reference::RhoMethod rho) const {
        return {.scene = scene,
                .images = images_,
                .time = seconds_,
                .width = width_,
                .height = height_,
                .rho = rho,
                .cornerBits = cornerBits,
                .zeroSwitchOver = true};
    }

    reference::ReferenceRenderer renderer_;
    ImageSource images_;
    double seconds_;
    int width_;
    int height_;
};

/// One picture, into a line.
int judgeOne(const Scene& scene, const ImageSource& images, const char* seconds, const char* picture,
             const char* expected) {
    const Result<Bytes> file = readFile(picture);
    Result<Image> found = file ? decodeImage(*file) : fail(file.error());
    if (!found)
        return complain(found.error());
    if (found->format != PixelFormat::Rgba8)
        return complain({ErrorCode::Unsupported, "expected a picture of RGBA", picture});
    makeOpaque(*found);
    Reference reference(images, std::strtod(seconds, nullptr), found->width, found->height);
    const Result<Frame> drawn = reference.draw(scene);
    if (!drawn)
        return complain(drawn.error());
    const conform::Rule& rule = suite::ruleFor(scene);
    const auto judgement = conform::judge(rule, scene, drawn->image, *found, reference);
    if (!judgement)
        return complain(judgement.error());
    if (judgement->unexplained > 0) {
        const Result<Bytes> png = encodePng(drawn->image);
        if (const Result<void> written = png ? writeFileAtomically(expected, *png) : fail(png.error());
            !written)
            return complain(written.error());
    }
    fmt::print("{{\"rule\": \"{}\", \"bound\": {}, \"explained\": {}, \"pixels\": {}, \"over\": {}, "
               "\"unexplained\": {}, \"max\": {}}}\n",
               rule.name, rule.bound, rule.explainedScene, judgement->difference.pixels,
               judgement->difference.over, judgement->unexplained, judgement->difference.max);
    return 0;
}

int judge(std::span<char*> words) {
    const Result<std::string> text = readText(words[1]);
    const Result<Scene> scene = text ? parseScene(*text) : fail(text.error());
    if (!scene)
        return complain(scene.error());
    ImageSource images{words[2]};
    if (const Result<void> loaded = images.load(*scene); !loaded)
        return complain(loaded.error());
    for (std::size_t i = 3; i < words.size(); i += 3) {
        if (const int status = judgeOne(*scene, images, words[i], words[i + 1], words[i + 2]); status != 0)
            return status;
    }
    return 0;
}

} // namespace
} // namespace texplorer

int main(int argc, char** argv) {
    if (argc < 6 || argc % 3 != 0) {
        fmt::print(stderr, "judge_picture SCENE FOLDER [SECONDS PICTURE EXPECTED]...\n");
        return texplorer::unable;
    }
    return texplorer::judge({argv, static_cast<std::size_t>(argc)});
}

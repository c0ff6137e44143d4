#include "texplorer/lesson/match.h"

#include "texplorer/compare/difference.h"
#include "texplorer/reference/draw.h"

#include <algorithm>

namespace texplorer::lesson {
namespace {

constexpr int bound = 2;               // of a component, in 255ths
constexpr double maxShareOver = 0.001; // of the pixels
constexpr std::size_t maxHints = 64;

/// Of two pictures of the same size.
double distance(const Image& a, const Image& b) {
    const Result<Difference> difference = compare(a, b, bound, Compared::Rgb);
    return difference ? difference->shareOver() + difference->mean / 1e6 : 1;
}

} // namespace

Result<Image> drawSmall(const LessonScene& scene, std::stop_token stop, PictureSize size) {
    reference::DrawOptions options;
    options.stop = std::move(stop);
    return reference::drawReference({scene.scene, scene.images, 0, size.width, size.height}, options)
        .map([](Frame frame) {
            // What a background's alpha lets through would be different on a page and in a window.
            for (std::size_t alpha = 3; alpha < frame.image.pixels.size(); alpha += 4)
                frame.image.pixels[alpha] = std::byte{255};
            return std::move(frame.image);
        });
}

bool areAlike(const Image& a, const Image& b) {
    const Result<Difference> difference = compare(a, b, bound, Compared::Rgb);
    return difference && difference->shareOver() <= maxShareOver;
}

namespace {

struct BothPictures {
    Image given;
    Image wanted;
};

Result<BothPictures> drawBoth(const Scene& scene, const Scene& target, const ImageSource& images,
                              const std::stop_token& stop) {
    Result<Image> wanted = drawSmall({target, images}, stop);
    if (!wanted)
        return fail(wanted.error());
    return drawSmall({scene, images}, stop).map([&](Image given) {
        return BothPictures{std::move(given), *std::move(wanted)};
    });
}

} // namespace

Result<Grade> gradeMatch(const Scene& scene, const Scene& target, const ImageSource& images,
                         std::stop_token stop) {
    const Result<BothPictures> both = drawBoth(scene, target, images, stop);
    if (!both)
        return fail(both.error());
    const bool passed = areAlike(both->given, both->wanted);
    return Grade{passed, passed ? 0 : distance(both->given, both->wanted)};
}

Result<std::optional<SceneChange>> hintFor(const Scene& scene, const Scene& target, const ImageSource& images,
                                           std::stop_token stop) {
    const Result<BothPictures> both = drawBoth(scene, target, images, stop);
    if (!both)
        return fail(both.error());
    const std::vector<SceneChange> changes = changesBetween(scene, target);
    double best = distance(both->given, both->wanted);
    std::optional<SceneChange> hint;
    for (std::size_t i = 0; i < std::min(changes.size(), maxHints); ++i) {
        Scene nearer = scene;
        if (!takeOver(nearer, target, {&changes[i].path, 1}))
            continue;
        const Result<Image> picture = drawSmall({nearer, images}, stop);
        if (!picture)
            return fail(picture.error());
        if (const double left = distance(*picture, both->wanted); left < best) {
            best = left;
            hint = changes[i];
        }
    }
    // Where it takes two at once, any of them is a beginning.
    if (!hint && !changes.empty())
        hint = changes.front();
    return hint;
}

} // namespace texplorer::lesson

#include "app/ui/services/pattern_pictures.h"

#include "texplorer/image/thumbnail.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/levels_worker.h"

#include <mutex>

namespace texplorer::ui {
namespace {

/// A constant that is computed at its first use, like the pattern itself.
std::shared_ptr<const Image> smallPattern(Pattern pattern) {
    struct Constant {
        std::once_flag drawn;
        std::shared_ptr<const Image> image;
    };
    static std::array<Constant, patternRows.size()> constants;
    Constant& constant = constants.at(static_cast<std::size_t>(pattern));
    std::call_once(constant.drawn, [&] {
        Texture texture;
        texture.pattern = pattern;
        const std::shared_ptr<const TextureImage> drawn = ImageSource{}.find(texture); // who shows it has it
        constant.image = std::make_shared<const Image>(
            thumbnailOf(toImage(drawn->surface(0, 0)), LevelsSummary::thumbnailExtent));
    });
    return constant.image;
}

} // namespace

PatternPictures::PatternPictures(When when, std::function<void()> wake)
    : when_(when)
    , worker_(
          {.when = when, .wake = std::move(wake)},
          [](const auto& task) -> std::optional<Picture> {
              return Picture{task.job(), smallPattern(task.job())};
          },
          [](Pattern pattern, const Error& /*error*/) {
              return Picture{pattern, nullptr};
          }) {}

bool PatternPictures::ask() {
    while (asked_ < patternRows.size() && !worker_.isWorking()) {
        worker_.ask(static_cast<Pattern>(patternRows[asked_++].value));
        if (when_ != When::AtOnce)
            break;
    }
    std::vector<Picture> arrived = worker_.take();
    for (Picture& made : arrived)
        pictures_.at(static_cast<std::size_t>(made.first)) = std::move(made.second);
    return !arrived.empty();
}

} // namespace texplorer::ui

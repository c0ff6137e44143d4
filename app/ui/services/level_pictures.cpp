#include "app/ui/services/level_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

using ByteTable = std::array<std::byte, 256>;

constexpr FailureWords pictureFailure{N_("not enough memory for a picture of the level"),
                                      N_("the picture of the level can't be made")};

/// The displayed byte for each value.
ByteTable tableOf(const TexelLook& look) {
    ByteTable table{};
    const float factor = std::exp2(look.exposure);
    const float extent = std::max(look.high - look.low, 1e-4F);
    for (std::size_t value = 0; value < table.size(); ++value) {
        const float shown = (static_cast<float>(value) / 255 * factor - look.low) / extent;
        table[value] = static_cast<std::byte>(std::lround(std::clamp(shown, 0.0F, 1.0F) * 255));
    }
    return table;
}

} // namespace

Image lookedAt(const Image& texels, const TexelLook& look) {
    const ByteTable table = tableOf(look);
    Image shown = texels;
    const auto of = [](std::byte value) { return std::to_integer<std::size_t>(value); };
    for (std::size_t at = 0; at + 3 < shown.pixels.size(); at += 4) {
        std::byte* texel = shown.pixels.data() + at;
        if (look.channel == Channel::All) {
            for (int i = 0; i < 3; ++i)
                texel[i] = table[of(texel[i])];
            continue;
        }
        const std::size_t value = look.channel == Channel::Luminance
                                      ? static_cast<std::size_t>(reference::luminanceOf(
                                            std::to_integer<int>(texel[0]), std::to_integer<int>(texel[1]),
                                            std::to_integer<int>(texel[2])))
                                      : of(texel[static_cast<std::size_t>(look.channel) - 1]);
        texel[0] = texel[1] = texel[2] = table[value];
        texel[3] = std::byte{255};
    }
    return shown;
}

LevelPictures::LevelPictures(When when, std::function<void()> wake)
    : worker_(
          {.when = when, .order = JobOrder::NewestWins, .words = pictureFailure, .wake = std::move(wake)},
          [](const Making::Task& task) { return std::optional(make(task)); },
          [](const Job& job, const Error& error) {
              return std::make_shared<const Answer>(Answer{.request = job.request, .problem = error.message});
          }) {}

std::shared_ptr<const LevelPictures::Answer> LevelPictures::make(const Making::Task& task) {
    const Job& job = task.job();
    auto made = std::make_shared<Answer>(Answer{.request = job.request});
    if (job.known) {
        made->texels = job.known->texels;
        made->statistics = job.known->statistics;
    } else {
        const PreparedLevels& levels = *job.levels;
        Result<Image> texels =
            levels ? reference::levelPicture(*levels, job.request.level, job.request.levels.target)
                   : Result<Image>(fail(levels.error()));
        if (!texels) {
            made->problem = texels.error().message;
            return made;
        }
        made->texels = std::make_shared<const Image>(std::move(*texels));
        made->statistics = reference::statisticsOf(*made->texels);
    }
    made->picture = job.request.look == TexelLook{}
                        ? made->texels
                        : std::make_shared<const Image>(lookedAt(*made->texels, job.request.look));
    return made;
}

void LevelPictures::take(LevelsWorker& source) {
    for (std::shared_ptr<const Answer>& answer : worker_.take())
        newest_ = std::move(answer);
    // Freeing so much memory takes time, too.
    if (levels_ && asked_ && newest_ && newest_->request.sameTexels(*asked_))
        source.uploaded(asked_->levels, std::exchange(levels_, nullptr), {});
}

std::shared_ptr<const LevelPictures::Answer> LevelPictures::answer(const LevelPictureRequest& request,
                                                                   LevelsWorker& source) {
    take(source);
    if (asked_ == request)
        return newest_;
    const bool known = newest_ && newest_->request.sameTexels(request);
    if (!known && !(levels_ && asked_ && asked_->sameTexels(request))) {
        levels_ = source.prepare(request.levels);
        asked_.reset();
        if (!levels_)
            return newest_;
        if (!*levels_ && levels_->error().code == ErrorCode::Cancelled) { // until the level is needed again
            newest_.reset();
            return std::make_shared<const Answer>(
                Answer{.request = request, .problem = std::exchange(levels_, nullptr)->error().message});
        }
    }
    asked_ = request;
    if (known && !newest_->texels) { // the level does not exist, and another look does not change that
        auto again = std::make_shared<Answer>(*newest_);
        again->request = request;
        newest_ = std::move(again);
        return newest_;
    }
    worker_.ask({request, known ? nullptr : levels_, known ? newest_ : nullptr});
    take(source);
    return newest_;
}

void LevelPictures::rest() {
    if (!asked_ && !newest_)
        return;
    worker_.clear();
    asked_.reset();
    levels_.reset();
    newest_.reset();
}

} // namespace texplorer::ui

#include "app/ui/services/recovery.h"

#include "texplorer/image/convert.h"
#include "texplorer/reference/draw.h"

#include <utility>

namespace texplorer::ui {
namespace {

constexpr int pictureWidth = 320;
constexpr int pictureHeight = 240;
constexpr FailureWords failure{N_("not enough memory for the picture"), N_("the picture can't be drawn")};

} // namespace

Recovery::Recovery(const std::filesystem::path& folder, std::function<void()> wake)
    : drawing_(
          {When::WhenReady, JobOrder::Queue, failure, std::move(wake)},
          [](const Drawing::Task& task) { return draw(task); },
          [](const Draft& draft, const Error& /*error*/) {
              return Picture{draft.number, nullptr};
          }) {
    for (Orphan& orphan : claimOrphans(folder)) {
        Result<UnsavedScene> draft =
            orphan.place ? orphan.place->read() : Result<UnsavedScene>(fail(orphan.place.error()));
        offers_.push_back(
            {std::move(orphan.place).value_or(UnsavedPlace()), orphan.written, std::move(draft)});
    }
    for (std::size_t i = 0; i < offers_.size(); ++i) {
        if (offers_[i].draft)
            drawing_.ask({i, *offers_[i].draft});
    }
}

Recovery::Picture Recovery::draw(const Drawing::Task& task) {
    const UnsavedScene& draft = task.job().scene;
    ImageSource images(draft.folder);
    Scene scene = draft.scene;
    (void)images.load(scene); // images that cannot be read are missing in the picture
    reference::DrawOptions options;
    options.levels.stop = options.stop = task.stop();
    Result<Frame> drawn =
        reference::drawReference({std::move(scene), images, 0, pictureWidth, pictureHeight}, options);
    if (!drawn)
        return {task.job().number, nullptr};
    return {task.job().number, std::make_shared<const Image>(withoutAlpha(std::move(drawn->image)))};
}

std::shared_ptr<const Image> Recovery::picture() const {
    std::shared_ptr<const Image> first;
    drawing_.look([&](const Picture& each) {
        if (each.number == decided_)
            first = each.image;
    });
    return first;
}

void Recovery::discard() {
    offers_.front().place.remove();
    offers_.erase(offers_.begin());
    ++decided_;
}

void Recovery::later() {
    decided_ += offers_.size();
    offers_.clear();
    drawing_.clear();
}

UnsavedScene Recovery::restore() {
    UnsavedScene draft = *std::move(offers_.front().draft);
    restored_ = std::move(offers_.front().place);
    later();
    return draft;
}

} // namespace texplorer::ui

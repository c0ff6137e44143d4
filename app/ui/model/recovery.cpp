#include "app/ui/model/recovery.h"

#include "core/image/convert.h"
#include "core/reference/draw.h"

#include <utility>

namespace texplorer::ui {
namespace {

constexpr int pictureWidth = 320;
constexpr int pictureHeight = 240;

} // namespace

Recovery::Recovery(const std::filesystem::path& folder, std::function<void()> wake)
    : wake_(std::move(wake)) {
    std::vector<UnsavedScene> drafts;
    for (Orphan& orphan : claimOrphans(folder)) {
        Result<UnsavedScene> draft = orphan.place.read();
        drafts.push_back(draft.value_or(UnsavedScene{}));
        offers_.push_back({std::move(orphan.place), orphan.written, std::move(draft)});
    }
    pictures_.resize(offers_.size());
    if (!offers_.empty())
        thread_ = std::jthread([this, all = std::move(drafts)](const std::stop_token& stop) mutable {
            draw(stop, std::move(all));
        });
}

Recovery::~Recovery() = default;

void Recovery::draw(const std::stop_token& stop, std::vector<UnsavedScene> drafts) {
    for (std::size_t i = 0; i < drafts.size() && !stop.stop_requested(); ++i) {
        ImageSource images(drafts[i].folder);
        (void)images.load(drafts[i].scene); // what can't be read is missing in the picture, too
        reference::DrawOptions options;
        options.levels.stop = options.stop = stop;
        Result<Frame> drawn =
            reference::drawReference({drafts[i].scene, images, 0, pictureWidth, pictureHeight}, options);
        if (!drawn)
            continue;
        {
            const std::scoped_lock lock(mutex_);
            pictures_[i] = std::make_shared<const Image>(withoutAlpha(std::move(drawn->image)));
        }
        if (wake_)
            wake_();
    }
}

std::shared_ptr<const Image> Recovery::picture() const {
    const std::scoped_lock lock(mutex_);
    return decided_ < pictures_.size() ? pictures_[decided_] : nullptr;
}

void Recovery::discard() {
    offers_.front().place.remove();
    offers_.erase(offers_.begin());
    ++decided_;
}

void Recovery::later() {
    decided_ += offers_.size();
    offers_.clear();
    thread_.request_stop();
}

UnsavedScene Recovery::restore() {
    UnsavedScene draft = *std::move(offers_.front().draft);
    restored_ = std::move(offers_.front().place);
    later();
    return draft;
}

} // namespace texplorer::ui

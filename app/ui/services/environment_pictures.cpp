#include "app/ui/services/environment_pictures.h"

#include "texplorer/image/thumbnail.h"
#include "texplorer/reference/shading/environment_table.h"

#include <utility>

namespace texplorer::ui {

EnvironmentPictures::EnvironmentPictures(When when, std::function<void()> wake)
    : worker_(
          when, std::move(wake),
          [](const auto& task) {
              const Question& asked = task.job();
              const Image texels =
                  asked.texels ? thumbnailOf(*asked.texels, maxExtent) : reference::hueAndAlpha(maxExtent);
              return std::make_shared<const Image>(reference::environmentPictures(
                  texels, {.fragment = asked.fragment, .constant = asked.constant}));
          },
          [](const Question& /*question*/) { return std::shared_ptr<const Image>(); }) {}

bool EnvironmentPictures::ask(const Question& question) {
    if (asked_ != question) {
        asked_ = question;
        worker_.ask(question);
    }
    std::optional<std::shared_ptr<const Image>> arrived = worker_.take();
    if (arrived)
        newest_ = *std::move(arrived);
    return arrived.has_value();
}

void EnvironmentPictures::rest() {
    if (!asked_)
        return;
    worker_.rest();
    asked_.reset();
    newest_.reset();
}

} // namespace texplorer::ui

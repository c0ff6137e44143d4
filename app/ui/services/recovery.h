#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/storage/unsaved_folder.h"

#include <functional>
#include <memory>
#include <vector>

namespace texplorer::ui {

/// Unsaved work of windows that crashed, offered one after the other. Their pictures are drawn by the
/// reference, on its own thread if one is available: the driver may have caused the crash.
class Recovery {
public:
    /// Claims every draft in the folder whose window is gone. `wake` is called when there is a picture.
    explicit Recovery(const std::filesystem::path& folder, std::function<void()> wake = {});

    struct Offer {
        UnsavedPlace place; ///< not open if its lock is not available: the draft cannot be discarded then
        std::filesystem::file_time_type written;
        Result<UnsavedScene> draft;
    };
    /// The offers that are not decided yet, the newest first.
    [[nodiscard]] const std::vector<Offer>& offers() const { return offers_; }
    /// The picture of the first offer; nullptr: not drawn yet, or none.
    [[nodiscard]] std::shared_ptr<const Image> picture() const;

    void discard(); ///< the first offer: removes its draft
    void later();   ///< all offers: they stay for another start
    /// Restores the first offer: its place is kept for the window that shows it. The others stay for another
    /// start.
    [[nodiscard]] UnsavedScene restore();
    /// The place of the restored work, once.
    [[nodiscard]] UnsavedPlace takeRestored() { return std::move(restored_); }

private:
    struct Draft {
        std::size_t number = 0; ///< of the offer, counted among all that were found
        UnsavedScene scene;
    };
    struct Picture {
        std::size_t number = 0;
        std::shared_ptr<const Image> image; ///< nullptr: it cannot be drawn
    };
    using Drawing = Worker<Draft, Picture>;
    [[nodiscard]] static Picture draw(const Drawing::Task& task);

    std::vector<Offer> offers_;
    UnsavedPlace restored_;
    std::size_t decided_ = 0; ///< the number of the first offer
    Drawing drawing_;
};

} // namespace texplorer::ui

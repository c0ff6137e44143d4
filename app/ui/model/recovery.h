#pragma once

#include "core/autosave/unsaved_folder.h"
#include "core/base/worker.h"
#include "core/image/image.h"

#include <functional>
#include <memory>
#include <vector>

namespace texplorer::ui {

/// The unsaved work of windows that have died, offered one after the other. Their pictures are drawn by the
/// reference, on a thread of its own where there is one to be had: what had ended the window may have been
/// the driver.
class Recovery {
public:
    /// Claims every draft in the folder whose window is gone. `wake` is called when there is a picture.
    explicit Recovery(const std::filesystem::path& folder, std::function<void()> wake = {});
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;
    ~Recovery();

    struct Offer {
        UnsavedPlace place; ///< not open where its lock can't be had: the draft can't be discarded then
        std::filesystem::file_time_type written;
        Result<UnsavedScene> draft;
    };
    /// Those that are not decided yet, the youngest first.
    [[nodiscard]] const std::vector<Offer>& offers() const { return offers_; }
    /// Of the first offer; nullptr: not drawn yet, or there is none.
    [[nodiscard]] std::shared_ptr<const Image> picture() const;

    void discard(); ///< the first: its draft is removed
    void later();   ///< all: they stay for another start
    /// The first is restored: its place is kept for the window that shows it. The others stay for another
    /// start.
    [[nodiscard]] UnsavedScene restore();
    /// The place of what was restored, once.
    [[nodiscard]] UnsavedPlace takeRestored() { return std::move(restored_); }

private:
    struct Draft {
        std::size_t number = 0; ///< of the offer, in the order of all that were found
        UnsavedScene scene;
    };
    struct Picture {
        std::size_t number = 0;
        std::shared_ptr<const Image> image; ///< nullptr: it can't be drawn
    };
    using Drawing = Worker<Draft, Picture>;
    [[nodiscard]] static Picture draw(const Drawing::Task& task);

    std::vector<Offer> offers_;
    UnsavedPlace restored_;
    std::size_t decided_ = 0; ///< the number of the first offer
    Drawing drawing_;
};

} // namespace texplorer::ui

#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/image/image.h"
#include "texplorer/image/patterns/pattern.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace texplorer::ui {

/// Small pictures of the built-in patterns, to choose from. Drawing all of them takes too long for a frame:
/// they are made on a separate thread, one in each frame.
class PatternPictures {
public:
    /// `wake` is called on that thread for each new picture.
    explicit PatternPictures(When when, std::function<void()> wake = {});

    /// Call in every frame that shows the pictures. Returns true if new ones have arrived.
    bool ask();
    /// nullptr: not ready.
    [[nodiscard]] std::shared_ptr<const Image> find(Pattern pattern) const {
        return pictures_.at(static_cast<std::size_t>(pattern));
    }

private:
    using Picture = std::pair<Pattern, std::shared_ptr<const Image>>;

    std::array<std::shared_ptr<const Image>, patternRows.size()> pictures_;
    const When when_;
    std::size_t asked_ = 0;           ///< how many, of patternRows
    Worker<Pattern, Picture> worker_; // last member: it ends before the others
};

} // namespace texplorer::ui

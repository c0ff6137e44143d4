#pragma once

#include "core/base/worker.h"
#include "core/image/image.h"
#include "core/image/patterns/pattern.h"

#include <array>
#include <functional>
#include <memory>
#include <utility>

namespace texplorer::ui {

/// Small pictures of the built-in patterns, for a choice among them. To draw all of them takes too long for a
/// frame: they are made on a thread of their own.
class PatternPictures {
public:
    /// `wake` is called on that thread whenever there is one more.
    explicit PatternPictures(When when, std::function<void()> wake = {});

    /// nullptr: not yet.
    [[nodiscard]] std::shared_ptr<const Image> find(Pattern pattern);

private:
    using Picture = std::pair<Pattern, std::shared_ptr<const Image>>;

    std::array<std::shared_ptr<const Image>, patternRows.size()> pictures_;
    bool asked_ = false;
    Worker<Pattern, Picture> worker_; // last: it ends before the rest does
};

} // namespace texplorer::ui

#include "core/scene/history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer {

History::History(Scene initial, std::size_t limit)
    : limit_(limit) {
    steps_.push_back({std::move(initial), {}});
}

void History::record(const Scene& scene, std::string_view what) {
    if (scene == current())
        return;
    const auto behind = steps_.begin() + static_cast<std::ptrdiff_t>(position_) + 1;
    std::vector<Step> redone(std::make_move_iterator(behind), std::make_move_iterator(steps_.end()));
    steps_.erase(behind, steps_.end()); // no redo any more
    if (!sealed_ && !what.empty() && steps_[position_].what == what) {
        steps_[position_].scene = scene;
        steps_[position_].picture.reset();
        return;
    }
    steps_.push_back({scene, std::string(what)});
    if (steps_.size() > limit_ + 1)
        steps_.erase(steps_.begin());
    position_ = steps_.size() - 1;
    redone_ = std::move(redone);
    sealed_ = false;
}

void History::seal() {
    redone_.clear();
    sealed_ = true;
}

const Scene& History::takeBack() {
    if (sealed_ || position_ == 0)
        return current();
    steps_.pop_back();
    --position_;
    steps_.insert(steps_.end(), std::make_move_iterator(redone_.begin()),
                  std::make_move_iterator(redone_.end()));
    seal();
    return current();
}

void History::replaceView(const View& from, const View& to) {
    for (std::vector<Step>* steps : {&steps_, &redone_}) {
        for (Step& step : *steps) {
            if (step.scene.view == from)
                step.scene.view = to;
        }
    }
}

const Scene& History::undo() {
    if (canUndo())
        --position_;
    seal();
    return current();
}

const Scene& History::redo() {
    if (canRedo())
        ++position_;
    seal();
    return current();
}

const Scene& History::goTo(std::size_t step) {
    position_ = std::min(step, steps_.size() - 1);
    seal();
    return current();
}

std::string_view History::undoName() const {
    return canUndo() ? std::string_view(steps_[position_].what) : std::string_view();
}

std::string_view History::redoName() const {
    return canRedo() ? std::string_view(steps_[position_ + 1].what) : std::string_view();
}

} // namespace texplorer

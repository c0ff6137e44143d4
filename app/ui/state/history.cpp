#include "app/ui/state/history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer::ui {

namespace {

/// About as much as a scene's lists take, and a little for the rest.
std::size_t bytesOf(const Scene& scene) {
    constexpr std::size_t fixed = std::size_t{32} << 10;
    const auto all = [](const auto& list) { return list.size() * sizeof(list[0]); };
    std::size_t bytes = fixed;
    for (const Model& model : scene.models) {
        const MeshData& mesh = model.mesh;
        bytes += all(mesh.positions) + all(mesh.normals) + all(mesh.colors) + all(mesh.texCoords) +
                 all(mesh.indices);
        for (const TexCoords& coords : model.texCoords)
            bytes += all(coords);
        for (const std::vector<int>& numbers : model.noTexCoord)
            bytes += all(numbers);
    }
    for (const KeyFrame& key : scene.timeline.keys)
        bytes += sizeof key + key.path.size() + key.value.size();
    return bytes;
}

} // namespace

History::History(Scene initial, std::size_t limit, std::size_t maxBytes)
    : limit_(limit)
    , maxBytes_(maxBytes) {
    steps_.push_back({std::move(initial), {}});
}

void History::record(const Scene& scene, Sentence what, std::optional<Reselection> reselects) {
    if (scene == current())
        return;
    const auto behind = steps_.begin() + static_cast<std::ptrdiff_t>(position_) + 1;
    std::vector<Step> redone(std::make_move_iterator(behind), std::make_move_iterator(steps_.end()));
    steps_.erase(behind, steps_.end()); // no redo any more
    if (!sealed_ && !what.empty() && steps_[position_].what == what) {
        Step& step = steps_[position_];
        step.scene = scene;
        step.picture.reset();
        if (step.reselects && reselects)
            step.reselects->after = std::move(reselects->after);
        else if (reselects)
            step.reselects = std::move(reselects);
        return forgetOldest();
    }
    steps_.push_back({scene, std::move(what), std::move(reselects)});
    forgetOldest();
    redone_ = std::move(redone);
    sealed_ = false;
}

void History::forgetOldest() {
    std::size_t kept = 0;
    std::size_t bytes = 0;
    for (auto step = steps_.rbegin(); step != steps_.rend() && kept <= limit_; ++step, ++kept) {
        bytes += bytesOf(step->scene);
        if (bytes > maxBytes_ && kept > 1)
            break;
    }
    steps_.erase(steps_.begin(), steps_.end() - static_cast<std::ptrdiff_t>(kept));
    position_ = steps_.size() - 1;
}

void History::seal() {
    redone_.clear();
    sealed_ = true;
}

void History::takeBack(Selection& selection) {
    if (sealed_ || position_ == 0)
        return;
    if (std::optional<Reselection>& reselects = steps_.back().reselects)
        selection = std::move(reselects->before);
    steps_.pop_back();
    --position_;
    steps_.insert(steps_.end(), std::make_move_iterator(redone_.begin()),
                  std::make_move_iterator(redone_.end()));
    seal();
}

void History::replaceView(const View& from, const View& to) {
    for (std::vector<Step>* steps : {&steps_, &redone_}) {
        for (Step& step : *steps) {
            if (step.scene.view == from)
                step.scene.view = to;
        }
    }
}

void History::goTo(std::size_t step, Selection& selection) {
    step = std::min(step, steps_.size() - 1);
    while (position_ != step) {
        const bool back = step < position_;
        if (!back)
            ++position_;
        if (const std::optional<Reselection>& reselects = steps_[position_].reselects)
            selection = back ? reselects->before : reselects->after;
        if (back)
            --position_;
    }
    seal();
}

Sentence History::undoName() const {
    return canUndo() ? steps_[position_].what : Sentence();
}

Sentence History::redoName() const {
    return canRedo() ? steps_[position_ + 1].what : Sentence();
}

} // namespace texplorer::ui

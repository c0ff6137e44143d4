#include "app/ui/state/history.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace texplorer::ui {

namespace {

/// About as much as the lists of scenes take, each once that they share, and a little for the rest.
class ListBytes {
public:
    std::size_t operator()(const Scene& scene) {
        constexpr std::size_t fixed = std::size_t{32} << 10;
        std::size_t bytes = fixed;
        const auto add = [&](const auto& list) {
            if (counted_.insert(list.data()).second)
                bytes += list.size() * sizeof(list[0]);
        };
        for (const Model& model : scene.models) {
            const MeshData& mesh = model.mesh;
            add(mesh.positions);
            add(mesh.normals);
            add(mesh.colors);
            add(mesh.texCoords);
            add(mesh.indices);
            std::ranges::for_each(model.texCoords, add);
            std::ranges::for_each(model.noTexCoord, add);
        }
        for (const KeyFrame& key : scene.timeline.keys)
            bytes += sizeof key + key.path.size() + key.value.size();
        return bytes;
    }

private:
    std::set<const void*> counted_;
};

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
    ListBytes bytesOf;
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

void History::change(const std::function<void(Scene&)>& change) {
    for (std::vector<Step>* steps : {&steps_, &redone_})
        for (Step& step : *steps)
            change(step.scene);
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

#pragma once

#include "app/ui/state/selection.h"
#include "texplorer/base/sentence.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// What was selected before and after a step that selects something, or gives objects other indices.
struct Reselection {
    Selection before{};
    Selection after{};
};

/// Undo and redo as a list of Scenes. Call `record` after each edit; consecutive edits with the same
/// non-empty `what` and no `seal` between them are one step (a drag is one step, not a hundred).
class History {
public:
    /// Keeps `limit` steps; of large scenes as many as fit in `maxBytes`, but at least one.
    explicit History(Scene initial, std::size_t limit = 200, std::size_t maxBytes = std::size_t{512} << 20);

    [[nodiscard]] const Scene& current() const { return steps_[position_].scene; }
    void record(const Scene& scene, Sentence what, std::optional<Reselection> reselects = {});
    void seal();
    /// Discards the last edit if it is not sealed: it leaves no step, and redo is as before it.
    void takeBack(Selection& selection);
    /// Changes every step. For changes that are not edits: a camera that follows the shape of its view, the
    /// vertices of a file that has arrived.
    void change(const std::function<void(Scene&)>& change);

    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    // `selection` becomes what was selected before an undone step, or after a redone one, if the step has a
    // Reselection. They do nothing if there is nothing to undo or redo.
    void undo(Selection& selection) { goTo(canUndo() ? position_ - 1 : position_, selection); }
    void redo(Selection& selection) { goTo(position_ + 1, selection); }

    [[nodiscard]] Sentence undoName() const; ///< the name of the step that undo reverts; empty: none
    [[nodiscard]] Sentence redoName() const;

    // The steps as a list, oldest first. The first has no name: it is the beginning, or the oldest that is
    // kept.
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    [[nodiscard]] std::size_t position() const { return position_; } ///< of `current`
    [[nodiscard]] const Sentence& nameOf(std::size_t step) const { return steps_[step].what; }
    [[nodiscard]] const Scene& sceneOf(std::size_t step) const { return steps_[step].scene; }
    void goTo(std::size_t step, Selection& selection); ///< undoes or redoes up to that step

    /// A small picture of a step; nullptr: none was set. It is dropped when the step changes.
    [[nodiscard]] const std::shared_ptr<const Image>& pictureOf(std::size_t step) const {
        return steps_[step].picture;
    }
    void setPicture(std::shared_ptr<const Image> picture) { steps_[position_].picture = std::move(picture); }

private:
    struct Step {
        Scene scene;
        Sentence what; ///< the edit that led to this step
        std::optional<Reselection> reselects{};
        std::shared_ptr<const Image> picture{};
    };
    void forgetOldest();

    std::vector<Step> steps_;
    std::vector<Step> redone_; ///< steps after it that the current edit removed
    std::size_t position_ = 0;
    std::size_t limit_;
    std::size_t maxBytes_;
    bool sealed_ = true;
};

} // namespace texplorer::ui

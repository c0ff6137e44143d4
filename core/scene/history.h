#pragma once

#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// Undo and redo as a list of Scenes. Call `record` after each edit; consecutive edits with the same
/// non-empty `what` and no `seal` between them are one step (a drag is one step, not a hundred).
class History {
public:
    /// Keeps `limit` steps; of large scenes as many as fit in `maxBytes`, but at least one.
    explicit History(Scene initial, std::size_t limit = 200, std::size_t maxBytes = std::size_t{512} << 20);

    [[nodiscard]] const Scene& current() const { return steps_[position_].scene; }
    void record(const Scene& scene, std::string_view what);
    void seal();
    /// Discards the last edit if it is not sealed: it leaves no step, and redo is as before it. Returns
    /// current().
    const Scene& takeBack();
    /// Replaces the camera `from` by `to` in every step. For changes that are not edits: a camera that
    /// follows the shape of its view.
    void replaceView(const View& from, const View& to);

    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    const Scene& undo(); ///< returns current(); does nothing if there is nothing to undo
    const Scene& redo();

    [[nodiscard]] std::string_view undoName() const; ///< the name of the step that undo reverts; empty: none
    [[nodiscard]] std::string_view redoName() const;

    // The steps as a list, oldest first. The first has no name: it is the beginning, or the oldest that is
    // kept.
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    [[nodiscard]] std::size_t position() const { return position_; } ///< of `current`
    [[nodiscard]] const std::string& nameOf(std::size_t step) const { return steps_[step].what; }
    [[nodiscard]] const Scene& sceneOf(std::size_t step) const { return steps_[step].scene; }
    const Scene& goTo(std::size_t step); ///< undoes or redoes up to that step; returns current()

    /// A small picture of a step; nullptr: none was set. It is dropped when the step changes.
    [[nodiscard]] const std::shared_ptr<const Image>& pictureOf(std::size_t step) const {
        return steps_[step].picture;
    }
    void setPicture(std::shared_ptr<const Image> picture) { steps_[position_].picture = std::move(picture); }

private:
    struct Step {
        Scene scene;
        std::string what; ///< the edit that led to this step
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

} // namespace texplorer

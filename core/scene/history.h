#pragma once

#include "core/image/image.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// Undo as a list of Scenes. `record` is called after an edit; edits with the same non-empty `what` that
/// follow each other without a `seal` between them are one step (a drag is one step, not a hundred).
class History {
public:
    /// Remembers `limit` steps, of large scenes as many as take `maxBytes`, and one in any case.
    explicit History(Scene initial, std::size_t limit = 200, std::size_t maxBytes = std::size_t{512} << 20);

    [[nodiscard]] const Scene& current() const { return steps_[position_].scene; }
    void record(const Scene& scene, std::string_view what);
    void seal();
    /// The last edit never was: it has no step, and what could be redone before it can be redone again.
    /// For one that isn't sealed yet; nothing happens otherwise. Returns current().
    const Scene& takeBack();
    /// Every step whose camera is `from` has `to` from now on. For what isn't an edit: a camera that follows
    /// the shape of its view.
    void replaceView(const View& from, const View& to);

    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    const Scene& undo(); ///< returns current(); does nothing where there is nothing to undo
    const Scene& redo();

    [[nodiscard]] std::string_view undoName() const; ///< what undo would take back; empty where nothing
    [[nodiscard]] std::string_view redoName() const;

    // The steps as a list, the oldest first. The first one has no name: it is where all began, or the oldest
    // that is still remembered.
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    [[nodiscard]] std::size_t position() const { return position_; } ///< of `current`
    [[nodiscard]] const std::string& nameOf(std::size_t step) const { return steps_[step].what; }
    [[nodiscard]] const Scene& sceneOf(std::size_t step) const { return steps_[step].scene; }
    const Scene& goTo(std::size_t step); ///< as many undos or redos; returns current()

    /// A small picture of a step; nullptr: nobody has made one. It is given up when the step goes on.
    [[nodiscard]] const std::shared_ptr<const Image>& pictureOf(std::size_t step) const {
        return steps_[step].picture;
    }
    void setPicture(std::shared_ptr<const Image> picture) { steps_[position_].picture = std::move(picture); }

private:
    struct Step {
        Scene scene;
        std::string what; ///< the edit that led here
        std::shared_ptr<const Image> picture{};
    };
    void forgetOldest();

    std::vector<Step> steps_;
    std::vector<Step> redone_; ///< what the edit in progress took away: steps behind it
    std::size_t position_ = 0;
    std::size_t limit_;
    std::size_t maxBytes_;
    bool sealed_ = true;
};

} // namespace texplorer

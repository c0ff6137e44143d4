#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace texplorer {

/// Undo as a list of Scenes. `record` is called after an edit; edits with the same non-empty `what` that
/// follow each other without a `seal` between them are one step (a drag is one step, not a hundred).
class History {
public:
    explicit History(Scene initial, std::size_t limit = 200);

    [[nodiscard]] const Scene& current() const { return steps_[position_].scene; }
    void record(const Scene& scene, std::string_view what);
    void seal();

    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    const Scene& undo(); ///< returns current(); does nothing where there is nothing to undo
    const Scene& redo();

    [[nodiscard]] std::string_view undoName() const; ///< what undo would take back; empty where nothing
    [[nodiscard]] std::string_view redoName() const;

private:
    struct Step {
        Scene scene;
        std::string what; ///< the edit that led here
    };
    std::vector<Step> steps_;
    std::size_t position_ = 0;
    std::size_t limit_;
    bool sealed_ = true;
};

} // namespace texplorer

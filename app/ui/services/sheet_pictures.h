#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/base/worker.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/sweep_axis.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Draws a scene with every pair of values of two parameters, without blocking the window: one picture after
/// the other, by the reference. A new question takes effect with the next picture and continues at its
/// position, so that all pictures follow a moving scene and none falls behind. At its end it cancels the
/// current drawing and waits for it. Call all functions on one thread.
class SheetPictures {
public:
    /// `wake` is called on the working thread when there is a new picture. `levels`: how textures are
    /// compressed at run time.
    explicit SheetPictures(When when, std::function<void()> wake = {}, LevelWork levels = {});

    struct Question {
        reference::DrawRequest picture; ///< for one cell, with its size; the scene without the axes' values
        SweepAxis rows;
        SweepAxis columns;

        bool operator==(const Question&) const = default;

        [[nodiscard]] std::size_t cells() const { return rows.values.size() * columns.values.size(); }
    };
    struct Cell {
        std::shared_ptr<const Image> image{}; ///< bottom row first; nullptr: not ready, or see `problem`
        Sentence problem{};                   ///< a sentence without its full stop
        std::uint64_t question = 0;           ///< the question that it answers, counted from 1
    };
    /// Row by row. A cell may be the answer to an earlier question about the same cells.
    using Cells = std::vector<Cell>;

    /// Call in every frame that shows the pictures. Returns true if new ones have arrived.
    bool ask(const Question& question);
    /// The newest picture of each cell.
    [[nodiscard]] Cells cells(const SweepAxis& rows, const SweepAxis& columns) const;

    /// Call when the pictures are no longer shown: cancels the current drawing, and frees pictures and
    /// textures.
    void rest();

    /// Blocks until everything is drawn.
    void wait() const { worker_.wait(); }

private:
    struct Job {
        std::uint64_t number = 0;
        std::optional<Question> question; ///< nothing: free the renderer's memory
    };
    struct Answer {
        std::uint64_t number = 0;
        Cells cells;
    };
    using Drawing = Worker<Job, Answer>;
    [[nodiscard]] std::optional<Answer> work(const Drawing::Task& task);
    [[nodiscard]] Cell draw(const Question& question, std::size_t cell, const Drawing::Task& task);

    // Used by the requesting thread.
    std::optional<Question> wanted_;
    std::uint64_t lastNumber_ = 0;
    std::uint64_t firstOfThese_ = 0; ///< the number of the first question about these cells
    Cells shown_;

    // Used by the drawing thread.
    const LevelWork levels_;
    reference::ReferenceRenderer renderer_;
    std::optional<Question> drawn_; ///< the question of `made_`
    Cells made_;
    std::size_t next_ = 0; ///< the next cell to draw

    Drawing worker_; // last member: it ends before the others
};

/// The scene with one value for each axis. Errors: those of setParam.
[[nodiscard]] Result<Scene> sheetScene(const Scene& scene, const SweepAxis& rows, std::size_t row,
                                       const SweepAxis& columns, std::size_t column);

} // namespace texplorer::ui

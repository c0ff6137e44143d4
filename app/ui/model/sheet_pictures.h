#pragma once

#include "core/base/worker.h"
#include "core/reference/draw.h"
#include "core/scene/params/sweep_axis.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Draws a scene with every pair of values of two parameters, for a window that must not wait: one picture
/// after the other, by the reference. A new question takes effect with the next picture, and goes on where
/// the one before it was: so all of them follow a scene that moves, without any being left behind. All
/// functions are to be called from one thread.
class SheetPictures {
public:
    /// `wake` is called on the thread that works whenever there is a new picture. `levels`: how textures are
    /// compressed at run time.
    explicit SheetPictures(When when, std::function<void()> wake = {}, LevelWork levels = {});
    SheetPictures(const SheetPictures&) = delete;
    SheetPictures& operator=(const SheetPictures&) = delete;
    ~SheetPictures(); ///< ends what is being drawn, and waits for that

    struct Question {
        reference::DrawRequest picture; ///< of one cell, with its size; the scene without the axes' values
        SweepAxis rows;
        SweepAxis columns;

        bool operator==(const Question&) const = default;

        [[nodiscard]] std::size_t cells() const { return rows.values.size() * columns.values.size(); }
    };
    struct Cell {
        std::shared_ptr<const Image>
            image{};                ///< bottom row first; nullptr: not yet, or `problem` says why not
        std::string problem{};      ///< a sentence without its full stop
        std::uint64_t question = 0; ///< to which it is the answer, counted from 1
    };
    /// Row by row. Each may be the answer to an earlier question about the same cells.
    using Cells = std::vector<Cell>;

    /// The newest that there is of each.
    [[nodiscard]] const Cells& cells(const Question& question);

    /// Whether there is more to come.
    [[nodiscard]] bool isDrawing() const;

    /// Nobody looks any more: ends what is being drawn, and forgets pictures and textures.
    void rest();

    /// Sleeps until everything is drawn.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The scene with a value of each axis. Errors: those of setParam.
[[nodiscard]] Result<Scene> sheetScene(const Scene& scene, const SweepAxis& rows, std::size_t row,
                                       const SweepAxis& columns, std::size_t column);

} // namespace texplorer::ui

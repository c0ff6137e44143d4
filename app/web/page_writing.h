#pragma once

#include "app/ui/services/file_writing.h"

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace texplorer::web {

/// Makes files in a copy of the program, which a Web Worker of the page runs: it gets all memory, and the
/// work needs no other input. If the browser makes no copy, the window waits for the file.
class PageWriting final : public ui::FileWriting {
public:
    explicit PageWriting(LevelWork levels)
        : FileWriting(When::AtOnce, {}, std::move(levels)) {}
    ~PageWriting() override { cancel(); }

    void write(ui::FileOrder order) override;
    [[nodiscard]] std::optional<ui::FileProgress> progress() const override;
    void cancel() override;

    /// The worker of the current file; 0: there is none.
    [[nodiscard]] unsigned worker() const { return worker_; }
    void progressed(float share) { share_ = share; }
    /// The worker has made the file, or not. `reason`: empty if it has not begun.
    void made(ui::MadeFile file) { end(std::move(file)); }
    void failed(const Sentence& reason);

protected:
    [[nodiscard]] std::vector<ui::FileNews> take() override;
    [[nodiscard]] Result<std::filesystem::path> put(const ui::FileOrder& order, ByteView bytes) override;

private:
    void startNext();
    void makeHere();
    void end(Result<ui::MadeFile> file);

    std::deque<ui::FileOrder> waiting_; ///< the first one is being made
    unsigned worker_ = 0;
    float share_ = 0;
    std::vector<ui::FileNews> news_;
};

} // namespace texplorer::web

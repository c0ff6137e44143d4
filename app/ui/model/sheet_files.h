#pragma once

#include "app/ui/model/file_news.h"
#include "core/base/worker.h"
#include "core/reference/draw.h"
#include "core/scene/params/sweep_axis.h"
#include "core/sheet/layout.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Document; // see document.h
struct Session;  // see session.h

/// Writes sheets of variations as PNG files, whose pictures the reference draws: the same pixels as those of
/// "texshot sweep --renderer reference". All functions are to be called from one thread.
class SheetFiles {
public:
    /// `wake` is called on the thread that works whenever there is news. `levels`: how textures are
    /// compressed at run time.
    explicit SheetFiles(When when, std::function<void()> wake = {}, LevelWork levels = {});
    SheetFiles(const SheetFiles&) = delete;
    SheetFiles& operator=(const SheetFiles&) = delete;
    ~SheetFiles(); ///< what isn't written by then never is

    struct Order {
        reference::DrawRequest picture; ///< of one cell, with its size; the scene without the axes' values
        SweepAxis rows;
        SweepAxis columns;
        sheet::Content content;
        std::filesystem::path file; ///< is replaced as a whole, or stays
    };

    /// Where everything would lie. Errors: those of sheet::layoutOf, there are no fonts.
    [[nodiscard]] Result<sheet::Layout> layoutOf(const sheet::Content& content);

    /// One sheet after the other. Errors: those of layoutOf.
    [[nodiscard]] Result<void> write(Order order);

    /// Of the sheet that is drawn; nothing: none is.
    [[nodiscard]] std::optional<FileProgress> progress() const;

    /// Gives up all that isn't written yet: its files stay what they were.
    void cancel();

    /// What there is to say of the last sheet that was written, or couldn't be: once.
    [[nodiscard]] std::optional<FileNews> takeNews();

    /// Sleeps until all is written.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The sheet that the window shows, with every value. Errors: those of sweptAxes, too many pictures.
[[nodiscard]] Result<SheetFiles::Order> sheetOrder(const Session& session);

/// "earth-sheet.png"
[[nodiscard]] std::string sheetFileName(const Document& document);

/// How large it would be as a file, in pixels. Errors: those, and a sheet that is too large.
[[nodiscard]] Result<glm::ivec2> sheetExtent(Session& session);

/// Writes it. Errors: those, and a name that isn't a PNG's.
[[nodiscard]] Result<void> saveSheet(Session& session, const std::filesystem::path& file);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/file_writing.h"
#include "core/reference/draw.h"
#include "core/scene/params/sweep_axis.h"
#include "core/sheet/layout.h"

#include <filesystem>
#include <string>

namespace texplorer::ui {

struct Document; // see document.h
struct Session;  // see session.h

/// What a sheet of variations is made of. Its pictures are those of "texshot sweep --renderer reference".
struct SheetOrder {
    reference::DrawRequest picture; ///< of one cell, with its size; the scene without the axes' values
    SweepAxis rows;
    SweepAxis columns;
    sheet::Content content;
};

/// The sheet that the window shows, with every value. Errors: those of sweptAxes, too many pictures.
[[nodiscard]] Result<SheetOrder> sheetOrder(const Session& session);

/// The PNG file that it becomes. Errors: those of sheet::layoutOf, there are no fonts.
[[nodiscard]] Result<FileOrder> fileOrder(SheetOrder sheet, std::filesystem::path file);

/// "earth-sheet.png"
[[nodiscard]] std::string sheetFileName(const Document& document);

/// How large it would be as a file, in pixels. Errors: those of sheetOrder and fileOrder.
[[nodiscard]] Result<glm::ivec2> sheetExtent(const Session& session);

/// Has it written. Errors: those, and a name that isn't a PNG's.
[[nodiscard]] Result<void> saveSheet(Session& session, const std::filesystem::path& file,
                                     const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui

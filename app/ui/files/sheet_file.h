#pragma once

#include "app/ui/services/file_writing.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/sweep_axis.h"
#include "texplorer/sheet/layout.h"

#include <filesystem>
#include <string>

namespace texplorer::ui {

struct Document; // see document.h
struct Session;  // see session.h

/// The inputs of a sheet of variations. Its pictures are those of "texshot sweep --renderer reference".
struct SheetOrder {
    reference::DrawRequest picture; ///< for one cell, with its size; the scene without the axes' values
    SweepAxis rows;
    SweepAxis columns;
    sheet::Content content;
};

/// The shown sheet with all values. Errors: those of sweptAxes, too many pictures.
[[nodiscard]] Result<SheetOrder> sheetOrder(const Session& session);

/// The order for its PNG file. Errors: those of sheet::layoutOf, no fonts are available.
[[nodiscard]] Result<FileOrder> fileOrder(SheetOrder sheet, std::filesystem::path file);

/// "earth-sheet.png"
[[nodiscard]] std::string sheetFileName(const Document& document);

/// The size of its file in pixels. Errors: those of sheetOrder and fileOrder.
[[nodiscard]] Result<glm::ivec2> sheetExtent(const Session& session);

/// Writes it. Errors: those, and a name that is not valid for a PNG.
[[nodiscard]] Result<void> saveSheet(Session& session, const std::filesystem::path& file,
                                     const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui

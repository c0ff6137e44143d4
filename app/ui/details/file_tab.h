#pragma once

#include "app/ui/model/session.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// What the tab shows of its file. Fields are indices into the anatomy.
struct FileTabState {
    std::shared_ptr<const DissectedFile> content; ///< what the fields are of
    std::optional<std::size_t> hovered;           ///< the field under the mouse, in the table or in the bytes
    std::optional<std::size_t> revealInTable;
    std::optional<std::size_t> revealInBytes;
};

void drawFileTab(Session& session, FileTabState& state);

} // namespace texplorer::ui

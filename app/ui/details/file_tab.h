#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// The state of the tab. Fields are indices into the anatomy.
struct FileTabState {
    std::shared_ptr<const DissectedFile> content; ///< the file of the fields
    std::optional<std::size_t> hovered;           ///< the field under the mouse, in the table or in the bytes
    std::optional<std::size_t> revealInTable;
    std::optional<std::size_t> revealInBytes;
};

void drawFileTab(const Session& session, FileTabState& state, const Pictures& pictures);

} // namespace texplorer::ui

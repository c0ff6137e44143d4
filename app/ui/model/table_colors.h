#pragma once

#include "app/ui/model/session.h"
#include "app/view/size.h"
#include "core/reference/shading/environment_table.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// What the table of environments is about: the selected unit.
struct TableSubject {
    reference::TableColors colors;
    bool probed = false; ///< those of the probed pixel; else glColor and the mean of the image
    std::shared_ptr<const Image> texels{}; ///< of the bound texture; nullptr: none is bound, or not yet
    std::optional<BaseFormat> format{};    ///< of the bound texture; nothing: none is bound
    bool hasChoice = false; ///< the internal format decides on it, not the blocks that it is stored in
};

/// What the environment sees of a texture; nullptr: of its levels nothing is known yet.
[[nodiscard]] BaseFormat baseFormatOf(const Texture& texture, const LevelsSummary* summary);

/// Asks for the colours of the probed pixel, in a picture of this size, as they would be if the texture kept
/// all four components of its image: whatever its format is now, each row of the table takes its part.
[[nodiscard]] TableSubject tableSubject(Session& session, view::Size picture);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "app/view/size.h"
#include "texplorer/reference/shading/environment_table.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// The inputs of the table of environments, from the selected unit.
struct TableSubject {
    reference::TableColors colors;
    bool probed = false; ///< colours of the probed pixel; else glColor and the mean of the image
    std::shared_ptr<const Image> texels{}; ///< of the bound texture; nullptr: none is bound, or not ready
    std::optional<BaseFormat> format{};    ///< of the bound texture; nothing: none is bound
    bool hasChoice = false;                ///< set by the internal format, not by stored blocks
};

/// The base format that the environment uses for a texture; nullptr: nothing is known about its levels yet.
[[nodiscard]] BaseFormat baseFormatOf(const Texture& texture, const LevelsSummary* summary);

/// Call once per frame, before the panels. If the table is shown, asks for the colours of the probed pixel,
/// in a picture of this size, as if the texture kept all four components of its image: each row of the table
/// takes its components, regardless of the current format.
void askAboutTable(Session& session, view::Size picture);

[[nodiscard]] TableSubject tableSubject(const Session& session);

} // namespace texplorer::ui

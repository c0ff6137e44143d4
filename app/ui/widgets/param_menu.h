#pragma once

#include "app/ui/model/session.h"
#include "texplorer/scene/params/params.h"

#include <string>

namespace texplorer::ui {

/// The last widget opens the menu of its row, by a right click or the menu key.
void opensParamMenu();

/// The menu of a row while it is open: to reset and pin it, for its key frames and for the sheet. Returns
/// true if it resets the row.
[[nodiscard]] bool paramMenu(const Session& session, const ParamRow& row, const std::string& path,
                             const Value& initial, bool changed);

/// "Reset to 1"
[[nodiscard]] std::string resetWords(const ParamRow& row, const Value& initial);

/// A diamond after the label of a parameter with key frames: filled if there is one at the present time.
void keySign(const Session& session, const std::string& path);

} // namespace texplorer::ui

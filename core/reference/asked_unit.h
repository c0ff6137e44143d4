#pragma once

#include "texplorer/base/result.h"
#include "texplorer/reference/shading/pass_state.h"

#include <span>
#include <string>

namespace texplorer::reference {

/// "passes[0].units[1]"
[[nodiscard]] std::string unitName(int pass, int unit);

/// Returns the unit of a question. Errors: OutOfRange if the pass or the unit does not exist; Unsupported if
/// the unit samples nothing.
[[nodiscard]] Result<const UnitState*> askedUnit(std::span<const PassState> passes, int pass, int unit);

} // namespace texplorer::reference

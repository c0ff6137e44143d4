#include "texplorer/reference/asked_unit.h"

#include <fmt/core.h>

namespace texplorer::reference {

std::string unitName(int pass, int unit) {
    return fmt::format("passes[{}].units[{}]", pass, unit);
}

Result<const UnitState*> askedUnit(std::span<const PassState> passes, int pass, int unit) {
    if (pass < 0 || static_cast<std::size_t>(pass) >= passes.size())
        return fail(ErrorCode::OutOfRange,
                    Sentence("there is no pass {0}, the scene has {1}", pass, passes.size()));
    if (unit < 0 || unit >= maxUnits)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a unit from 0 to {0}, found {1}", maxUnits - 1, unit));
    const UnitState& found = passes[static_cast<std::size_t>(pass)].units[static_cast<std::size_t>(unit)];
    if (!found.texture)
        return fail(ErrorCode::Unsupported,
                    Sentence("{0} samples nothing: it is off or its texture can't be drawn",
                             ProperName{unitName(pass, unit)}));
    return &found;
}

} // namespace texplorer::reference

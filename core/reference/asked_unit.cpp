#include "texplorer/reference/asked_unit.h"

#include <fmt/core.h>

namespace texplorer::reference {

std::string unitName(int pass, int unit) {
    return fmt::format("passes[{}].units[{}]", pass, unit);
}

Result<const UnitState*> askedUnit(std::span<const PassState> passes, int pass, int unit) {
    if (pass < 0 || static_cast<std::size_t>(pass) >= passes.size())
        return fail(ErrorCode::OutOfRange,
                    fmt::format("there is no pass {}, the scene has {}", pass, passes.size()));
    if (unit < 0 || unit >= maxUnits)
        return fail(ErrorCode::OutOfRange,
                    fmt::format("expected a unit from 0 to {}, found {}", maxUnits - 1, unit));
    const UnitState& found = passes[static_cast<std::size_t>(pass)].units[static_cast<std::size_t>(unit)];
    if (!found.texture)
        return fail(
            ErrorCode::Unsupported,
            fmt::format("{} samples nothing: it is off or its texture can't be drawn", unitName(pass, unit)));
    return &found;
}

} // namespace texplorer::reference

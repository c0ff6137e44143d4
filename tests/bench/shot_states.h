#pragma once

// The 36 states that many shots in one call are measured with: every minification filter with every
// environment mode, of the scene that Texplorer starts with.

#include "texplorer/gl/enum_row.h"
#include "texplorer/gl/environment.h"
#include "texplorer/gl/sampling.h"

namespace texplorer::bench {

inline constexpr int statesExtent = 512;

/// Calls visit(filter, mode) for each.
void eachState(const auto& visit) {
    for (const EnumRow& filter : EnumTable<MinFilter>::rows) {
        for (const EnumRow& mode : EnumTable<EnvMode>::rows)
            visit(filter, mode);
    }
}

} // namespace texplorer::bench

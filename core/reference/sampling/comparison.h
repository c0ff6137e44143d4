#pragma once

#include "texplorer/gl/fragment.h"

namespace texplorer::reference {

/// Whether the comparison of `value` with `with` passes: OpenGL 2.1, sections 3.8.14 and 4.1.6.
template<class T>
[[nodiscard]] constexpr bool passes(CompareFunc function, T value, T with) {
    switch (function) {
    case CompareFunc::Never:
        return false;
    case CompareFunc::Less:
        return value < with;
    case CompareFunc::Equal:
        return value == with;
    case CompareFunc::LessEqual:
        return value <= with;
    case CompareFunc::Greater:
        return value > with;
    case CompareFunc::NotEqual:
        return value != with;
    case CompareFunc::GreaterEqual:
        return value >= with;
    case CompareFunc::Always:
        return true;
    }
    return true;
}

} // namespace texplorer::reference

#pragma once

#include <string>

namespace texplorer {

/// Formats a share of 0 to 1 as "12.3 %": three digits, or more where it would otherwise read "100 %" below
/// 1. A share above 0 never reads "0 %". No exponents.
[[nodiscard]] std::string percentText(double share);

} // namespace texplorer

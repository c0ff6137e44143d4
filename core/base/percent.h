#pragma once

#include <string>

namespace texplorer {

/// A share, 0 to 1, as "12.3 %": three digits, and as many more as it takes for what isn't all not to read
/// "100 %". What isn't nothing is never "0 %", and there are no exponents.
[[nodiscard]] std::string percentText(double share);

} // namespace texplorer

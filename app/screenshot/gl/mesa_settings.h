#pragma once

// Variables of the environment that Mesa reads when it is loaded. What the user has set is left alone.

namespace texplorer::screenshot {

/// Mesa takes shortcuts where it chooses mip levels and filters, unless it is told not to: without them, what
/// remains are errors.
inline constexpr const char* mesaPrecisionVariable = "GALLIVM_PERF";
inline constexpr const char* mesaPrecision = "no_rho_approx,no_brilinear,no_quad_lod,no_aos_sampling";

/// Where other processes draw at the same time, threads would only wait for each other.
inline constexpr const char* mesaThreadsVariable = "LP_NUM_THREADS";
inline constexpr const char* mesaNoThreads = "0";

} // namespace texplorer::screenshot

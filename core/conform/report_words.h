#pragma once

// What a report says in the same words wherever it says it.

#include "core/conform/sweep.h"

#include <array>
#include <string>

namespace texplorer::conform {

/// "0", "<0.01 %", "0.56 %"
[[nodiscard]] std::string percent(double share);

/// What a rule allows: "0 over 1", "0.5 % over 2, 0.2 % unexplained"
[[nodiscard]] std::string allowed(const Rule& rule);
/// What it allows any single scene: "1 % unexplained", "20 % over 16, 5 % over 128"
[[nodiscard]] std::string allowedOfScene(const Rule& rule);
/// What it allows of all scenes; where there is more than that by chance, with what so many scenes may have:
/// "4 % over 2 (of 64 scenes 5.13 %), 0.05 % unexplained"
[[nodiscard]] std::string allowed(const Outcome& outcome);

/// What OpenGL leaves open of rho, as far as a driver made use of it: "12 scenes drawn with rho at the lower
/// end …"; empty: it didn't.
[[nodiscard]] std::string rhoText(const Outcome& outcome);

/// How many scenes of a feature were skipped, for whatever reason.
[[nodiscard]] int skippedOf(const Outcome& outcome);

/// Where the worst pixel is, from the upper left as `texshot probe --at` counts.
[[nodiscard]] std::array<int, 2> placeOfWorst(const Judgement& judgement);

/// "2000 scenes of 64 x 64 pixels, seed 1"
[[nodiscard]] std::string whatWasDrawn(const Report& report);

/// " on llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6, with GALLIVM_PERF=…";
/// empty without a driver.
[[nodiscard]] std::string onWhat(const Driver& driver);

} // namespace texplorer::conform

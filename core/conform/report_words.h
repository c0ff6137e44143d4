#pragma once

// Phrases that several forms of a report share.

#include "texplorer/conform/sweep.h"

#include <array>
#include <string>

namespace texplorer::conform {

/// "0", "<0.01 %", "0.56 %"
[[nodiscard]] std::string percent(double share);

/// What a rule allows over all scenes: "0 over 1", "0.5 % over 2, 0.2 % unexplained"
[[nodiscard]] std::string allowed(const Rule& rule);
/// What it allows in a single scene: "1 % unexplained", "20 % over 16, 5 % over 128"
[[nodiscard]] std::string allowedOfScene(const Rule& rule);
/// What it allows over all scenes, and for a small sample the larger share that is within chance: "4 % over 2
/// (of 64 scenes 5.13 %), 0.05 % unexplained"
[[nodiscard]] std::string allowed(const Outcome& outcome);

/// How the driver used the range that OpenGL allows for rho: "12 scenes drawn with rho at the lower end …";
/// empty: it did not.
[[nodiscard]] std::string rhoText(const Outcome& outcome);

/// The number of skipped scenes of a feature, for any reason.
[[nodiscard]] int skippedOf(const Outcome& outcome);

/// The position of the worst pixel, from the upper left as in `texshot probe --at`.
[[nodiscard]] std::array<int, 2> placeOfWorst(const Judgement& judgement);

/// "2000 scenes of 64 x 64 pixels, seed 1"
[[nodiscard]] std::string whatWasDrawn(const Report& report);

/// " on llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6, with GALLIVM_PERF=…";
/// empty without a driver.
[[nodiscard]] std::string onWhat(const Driver& driver);

} // namespace texplorer::conform

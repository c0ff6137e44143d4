#pragma once

// Judges the picture of a case.

#include "texplorer/conform/pair.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/record.h"

namespace texplorer::suite {

/// The result of a case, without what only its runner knows: seconds, attempt, explanation, names of
/// pictures.
struct JudgedCase {
    CaseRecord record;
    /// Rgba8, bottom row first, like all images; empty: there is no golden, or it cannot be read.
    std::optional<Image> expected;
    std::optional<Image> difference; ///< if it failed with equal sizes: Rgba8, opaque
    /// An Error because its golden is not a valid picture; a new golden fixes it.
    bool goldenIsBroken = false;
};

/// How the reference filters in a case, as the renderer, to judge and to explain: as in `texshot shot`, but
/// as in Mesa if a driver's picture is compared with it.
[[nodiscard]] reference::AnisotropyMethod anisotropyOf(const Golden& golden, const conform::Driver& driver);

/// `actual`, Rgba8, is the picture of `scene`, whose images are loaded, by the case's renderer on `driver`
/// (empty for the reference). The result is Passed, Failed, Resized, New, Skipped (by conform's table, with
/// the reason) or Error (a golden or mask that cannot be read, a comparison that is not possible). Of several
/// goldens, the first that matches is used; if none does, the nearest is shown. `threads` for the reference
/// and the comparison; 0: one per processor.
[[nodiscard]] JudgedCase judgeCase(const Plan& plan, const Case& of, const CaseScene& scene,
                                   const Image& actual, const conform::Driver& driver, unsigned threads = 1);

/// Judges two pictures, for --pictures. `name` is the case's, and the golden's.
[[nodiscard]] JudgedCase judgePictures(const Criterion& criterion, const std::string& name,
                                       const Image& expected, const Image& actual,
                                       const Image* mask = nullptr, unsigned threads = 1);

/// The record of a case without a picture: `state` and the reason.
[[nodiscard]] CaseRecord recordOf(const Plan& plan, const Case& of, State state, Sentence sentence);

/// The record of a case whose scene could not be read (MissingScene, Error); empty: it can.
[[nodiscard]] std::optional<CaseRecord> recordWithoutDrawing(const Plan& plan, const Case& of);

/// The record of a case that is skipped on this driver; empty: it can be drawn.
[[nodiscard]] std::optional<CaseRecord>
recordWithoutDrawing(const Plan& plan, const Case& of, const CaseScene& scene, const conform::Driver& driver);

} // namespace texplorer::suite

#pragma once

// Whether a picture is what its case is held against.

#include "core/conform/pair.h"
#include "core/reference/sampling/lod.h"
#include "core/suite/case_scene.h"
#include "core/suite/record.h"

namespace texplorer::suite {

/// What comes of a case, but for what its runner knows: seconds, attempt, explanation, names of pictures.
struct JudgedCase {
    CaseRecord record;
    std::optional<Image> expected;   ///< Rgba8, bottom row first, as all images; none: there is no golden, or
                                     ///< it can't be read
    std::optional<Image> difference; ///< where it failed and the sizes are the same: Rgba8, opaque
    bool goldenIsBroken = false; ///< Error, for its golden is read and holds no picture: a new one mends it
};

/// How the reference filters in a case, as the renderer, to judge and to explain: as `texshot shot` does, and
/// as Mesa does where a driver's picture is held against it.
[[nodiscard]] reference::AnisotropyMethod anisotropyOf(const Golden& golden);

/// `actual`, Rgba8, is what the case's renderer drew on `driver` (empty for the reference) of `scene`, whose
/// images are loaded. Passed, Failed, Resized, New, Skipped (by conform's table of what can't be compared,
/// with its reason) or Error (a golden or mask that can't be read, a comparison that can't be made). Of
/// several goldens the first that it is like; where it is like none, the nearest is shown. `threads` for the
/// reference and the comparison; 0: as many as there are processors.
[[nodiscard]] JudgedCase judgeCase(const Plan& plan, const Case& of, const CaseScene& scene,
                                   const Image& actual, const conform::Driver& driver, unsigned threads = 1);

/// Two pictures as they are: for --pictures. `name` is the case's, and the golden's.
[[nodiscard]] JudgedCase judgePictures(const Criterion& criterion, const std::string& name,
                                       const Image& expected, const Image& actual,
                                       const Image* mask = nullptr, unsigned threads = 1);

/// The record of a case that came to no picture: `state` and why.
[[nodiscard]] CaseRecord recordOf(const Plan& plan, const Case& of, State state, std::string sentence);

/// Of a case whose scene the plan couldn't read (MissingScene, Error); none: it can be opened.
[[nodiscard]] std::optional<CaseRecord> recordWithoutDrawing(const Plan& plan, const Case& of);

/// Of a case that is skipped on this driver; none: it can be drawn.
[[nodiscard]] std::optional<CaseRecord>
recordWithoutDrawing(const Plan& plan, const Case& of, const CaseScene& scene, const conform::Driver& driver);

} // namespace texplorer::suite

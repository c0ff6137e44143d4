#pragma once

// Whether a picture is what its case is held against.

#include "core/conform/pair.h"
#include "core/suite/case_scene.h"
#include "core/suite/record.h"

namespace texplorer::suite {

/// What comes of a case, but for what its runner knows: seconds, attempt, explanation, names of pictures.
struct JudgedCase {
    CaseRecord record;
    std::optional<Image> expected; ///< Rgba8, bottom row first, as all images; none: there is no golden, or
                                   ///< it can't be read
    std::optional<Image> difference; ///< where it failed and the sizes are the same
};

/// `actual` is what the case's renderer drew on `driver` (empty for the reference) of `scene`, whose images
/// are loaded. Passed, Failed, New, Skipped (by conform's table of what can't be compared, with its reason)
/// or Error (a golden or mask that can't be read). Of several goldens the first that it is like; where it is
/// like none, the nearest is shown.
[[nodiscard]] JudgedCase judgeCase(const Plan& plan, const Case& of, CaseScene& scene, const Image& actual,
                                   const conform::Driver& driver);

/// Two pictures, as they are, by a suite's settings: for --pictures.
[[nodiscard]] JudgedCase judgePictures(const Settings& settings, const std::string& name,
                                       const Image& expected, const Image& actual);

/// The record of a case that came to no picture: `state` and why.
[[nodiscard]] CaseRecord recordOf(const Plan& plan, const Case& of, State state, std::string sentence);

/// Before anything is drawn: a problem of the plan, or what the comparison skips. None: it can be drawn.
[[nodiscard]] std::optional<CaseRecord>
recordWithoutDrawing(const Plan& plan, const Case& of, const CaseScene& scene, const conform::Driver& driver);

} // namespace texplorer::suite

#pragma once

// The cases of suites: one picture each.

#include "texplorer/scene/params/sweep_axis.h"
#include "texplorer/suite/suite.h"

namespace texplorer::suite {

inline constexpr std::size_t maxCases = 100'000;

struct Case {
    std::string name{}; ///< "bricks/minFilter=GL_NEAREST/wrapS=GL_REPEAT/shader@512x512"; unique in the plan
    std::string file{}; ///< fileNameFor of the name: for its pictures
    std::string goldenName{};  ///< the replacement for `{case}`: `file` without the suite's name
    std::string pictureName{}; ///< the replacement for `{picture}`: the same without the renderer
    std::size_t suite = 0;     ///< in the plan
    std::size_t entry = 0;     ///< in the suite
    std::size_t scene = 0;     ///< in the entry
    std::vector<Edit> edits{}; ///< of the axes, applied after the entry's
    RendererKind renderer = RendererKind::Fixed;
    PictureSize size{};
    double time = 0;
    std::optional<Error> problem{}; ///< why its scene cannot be read; NotFound: the file is missing

    bool operator==(const Case&) const = default;
};

struct Plan {
    std::vector<Suite> suites;
    std::vector<Case> cases;

    [[nodiscard]] const Suite& suiteOf(const Case& each) const { return suites[each.suite]; }
    [[nodiscard]] const Entry& entryOf(const Case& each) const { return suiteOf(each).entries[each.entry]; }
    [[nodiscard]] const Settings& settingsOf(const Case& each) const { return entryOf(each).settings; }
};

struct PlanOptions {
    std::vector<RendererKind> renderers{}; ///< replace those of every entry; empty: do not
    std::vector<std::string> only{};       ///< globs, one of which must match; empty: all cases
    std::size_t limit = maxCases;          ///< of all cases, before `only` selects
};

/// Makes the cases: scenes x axes x renderers x sizes x times of every entry, in this order. If a plan has
/// several suites, each name begins with the suite's. Scenes are read to expand "*" in axes. An entry whose
/// scene cannot be read has a case for each renderer, size and time, with the problem. Errors, with the suite
/// and the JSON pointer in `where`: TooLarge, with both numbers, before any case is made; impossible edits
/// and axes; the reference in `renderers` if it is the golden; two cases of one name; NotFound if `only`
/// matches no case.
[[nodiscard]] Result<Plan> planOf(std::vector<Suite> suites, const PlanOptions& options = {});

/// 32 hex digits that are equal for the same cases, in any order: identifies records of one run.
[[nodiscard]] std::string fingerprintOf(const Plan& plan);

} // namespace texplorer::suite

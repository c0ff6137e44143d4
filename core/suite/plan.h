#pragma once

// The cases of suites: a picture each.

#include "core/scene/params/sweep_axis.h"
#include "core/suite/suite.h"

namespace texplorer::suite {

inline constexpr std::size_t maxCases = 100'000;

struct Case {
    std::string name{}; ///< "bricks/minFilter=GL_NEAREST/wrapS=GL_REPEAT/shader@512x512"; unique in the plan
    std::string file{}; ///< fileNameFor the name: of its pictures
    std::string goldenName{};          ///< what `{case}` stands for: `file` without the suite's name
    std::string pictureName{};         ///< what `{picture}` stands for: the same without the renderer
    std::size_t suite = 0;             ///< in the plan
    std::size_t entry = 0;             ///< in the suite
    std::size_t scene = 0;             ///< in the entry
    std::vector<lesson::Edit> edits{}; ///< of the axes: after the entry's
    RendererKind renderer = RendererKind::Fixed;
    PictureSize size{};
    double time = 0;
    std::optional<Error> problem{}; ///< why its scene can't be had; NotFound: the file is missing

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
    std::vector<RendererKind> renderers{}; ///< in the place of every entry's; empty: theirs
    std::vector<std::string> only{};       ///< globs, of which one must fit; empty: all cases
    std::size_t most = maxCases;           ///< of all together, whatever `only` says
};

/// Every scene x axes x renderers x sizes x times of every entry, in this order. Where a plan has several
/// suites, each name begins with that of its suite. Scenes are read, for what "*" means in an axis. An entry
/// whose scene can't be read has a case for each renderer, size and time, with the problem. Errors, with the
/// suite and the JSON pointer in `where`: TooLarge, with both numbers, before any case is made; edits and
/// axes that can't be; the reference in `renderers` where it is the golden; two cases of one name; NotFound
/// where `only` fits no case.
[[nodiscard]] Result<Plan> planOf(std::vector<Suite> suites, const PlanOptions& options = {});

/// 32 hex digits that are the same for the same cases, in whatever order: for records of one run.
[[nodiscard]] std::string fingerprintOf(const Plan& plan);

} // namespace texplorer::suite

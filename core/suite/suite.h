#pragma once

// A suite as a value: which pictures of which scenes are drawn, and what each is held against. It is a file
// that one writes with a text editor, NAME.suite.json; what it names lies in its folder.

#include "core/base/result.h"
#include "core/compare/criterion.h"
#include "core/lesson/lesson.h"
#include "core/scene/renderer.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace texplorer::suite {

inline constexpr int suiteFormatVersion = 1;
inline constexpr std::string_view suiteExtension = ".suite.json";
inline constexpr std::size_t maxSuiteBytes = std::size_t{8} << 20;
inline constexpr std::size_t maxEntries = 10'000;
inline constexpr std::size_t maxScenes = 1'000; ///< of an entry; of its sizes and times, too
inline constexpr std::size_t maxAxes = 8;
inline constexpr std::size_t maxGoldens = 16; ///< of a list; of a list's drivers, too
inline constexpr std::size_t maxSuiteTextBytes = 4096;
inline constexpr int maxPictureSize = 16384;
inline constexpr double maxCaseSeconds = 86'400;

/// A scene's file, relative to the suite's folder; or, empty, what the program starts with.
struct SceneFile {
    std::string file;
    bool operator==(const SceneFile&) const = default;
};
/// One of the program's own: "checker".
struct SceneExample {
    std::string name;
    bool operator==(const SceneExample&) const = default;
};
/// A step of a lesson, as `texshot shot --lesson` has it. Steps and answers count from 1.
struct SceneLesson {
    std::string lesson; ///< one of the program's own, or a folder, relative to the suite's
    std::size_t step = 1;
    std::size_t answer = 0; ///< 0: what the step begins with
    bool reached = false;   ///< the picture that the step wants
    bool operator==(const SceneLesson&) const = default;
};
/// Written out in the suite.
struct SceneInline {
    std::string json;
    bool operator==(const SceneInline&) const = default;
};
using SceneSource = std::variant<SceneFile, SceneExample, SceneLesson, SceneInline>;

struct PictureSize {
    int width = 512;
    int height = 512;
    bool operator==(const PictureSize&) const = default;
};

/// Stored pictures, any of which will do, relative to the suite's folder: "golden/{case}.png",
/// "golden/{case}@{driver}.png"; "{picture}" is the case without its renderer, so that all renderers share
/// one.
struct GoldenFiles {
    /// Patterns for the drivers whose renderer string fits a glob; the longest that fits is the one.
    struct ForDriver {
        std::string driver; ///< "llvmpipe*"; "*" fits all, and the reference, whose driver is ""
        std::vector<std::string> patterns;
        bool operator==(const ForDriver&) const = default;
    };
    std::vector<ForDriver> drivers;
    bool operator==(const GoldenFiles&) const = default;
};
/// What the reference draws, held to a rule of the comparison (core/conform/rule.h).
struct GoldenReference {
    std::string rule =
        "auto"; ///< ruleNames: "auto" is ruleFor's, "none" the criterion, as of a stored picture
    bool operator==(const GoldenReference&) const = default;
};
using Golden = std::variant<GoldenFiles, GoldenReference>;

/// What an entry has, and may take over from the suite's `defaults`.
struct Settings {
    std::vector<PictureSize> sizes{PictureSize{}};
    std::vector<double> times{0}; ///< seconds
    std::vector<RendererKind> renderers{RendererKind::Fixed};
    Golden golden = GoldenFiles{{{"*", {"golden/{case}.png"}}}};
    Criterion criterion{}; ///< "metric", "tolerance", "share", "rgb", "pixelsPerDegree": of stored pictures
    std::string mask;      ///< a picture, relative to the folder, whose black pixels don't count; empty: none
    double seconds = 60;   ///< after which a case has hung
    bool operator==(const Settings&) const = default;
};

struct Entry {
    std::string name; ///< empty: made of the scene
    std::vector<SceneSource> scenes{SceneFile{}};
    std::vector<lesson::Edit> edits; ///< "set": to each of its scenes
    std::vector<std::string> axes;   ///< "textures[0].wrapS=*": as parseSweepAxis reads them
    Settings settings;
    bool operator==(const Entry&) const = default;
};

struct Suite {
    std::string name;             ///< "textures"
    std::string about;            ///< a sentence; may be empty
    std::filesystem::path folder; ///< what its names are relative to; empty: the current one
    std::filesystem::path file{}; ///< that it was read from; empty: none
    std::vector<Entry> entries;
    bool operator==(const Suite&) const = default;
};

/// Reads a suite's text; of its folder nothing is known yet. Malformed, Unsupported, OutOfRange or TooLarge,
/// with the JSON pointer in Error::where: no JSON (a line), unknown keys (with the nearest one that there
/// is), wrong types, lists that are too long, files that lead out of the folder.
[[nodiscard]] Result<Suite> parseSuite(std::string_view json);

/// A suite's file; its name is the file's where it says none. Errors with the file in `where`.
[[nodiscard]] Result<Suite> readSuite(const std::filesystem::path& file);

/// What a suite's file would be checked by in an editor: JSON Schema, draft 2020-12.
[[nodiscard]] std::string suiteSchema();

} // namespace texplorer::suite

#pragma once

// A suite: pictures of scenes, each with its golden. It is a text file, NAME.suite.json; the files that it
// refers to are in its folder.

#include "texplorer/base/result.h"
#include "texplorer/compare/criterion.h"
#include "texplorer/lesson/lesson.h"
#include "texplorer/scene/renderer.h"

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
inline constexpr std::size_t maxScenes = 1'000; ///< of an entry; also the limit of sizes and times
inline constexpr std::size_t maxAxes = 8;
inline constexpr std::size_t maxGoldens = 16; ///< of a list; also the limit of a list's drivers
inline constexpr std::size_t maxSuiteTextBytes = 4096;
inline constexpr int maxPictureSize = 16384;
inline constexpr double maxCaseSeconds = 86'400;

/// A scene file, relative to the suite's folder; empty: the program's default scene.
struct SceneFile {
    std::string file;
    bool operator==(const SceneFile&) const = default;
};
/// A built-in example: "checker".
struct SceneExample {
    std::string name;
    bool operator==(const SceneExample&) const = default;
};
/// A step of a lesson, as in `texshot shot --lesson`. Steps and answers are counted from 1.
struct SceneLesson {
    std::string lesson; ///< a built-in lesson, or a folder, relative to the suite's
    std::size_t step = 1;
    std::size_t answer = 0; ///< 0: the start of the step
    bool reached = false;   ///< the picture that the step asks for
    bool operator==(const SceneLesson&) const = default;
};
/// A scene in the suite itself.
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

/// Stored pictures, one of which must match, relative to the suite's folder: "golden/{case}.png",
/// "golden/{case}@{driver}.png"; "{picture}" is the case without its renderer, so that all renderers share
/// one.
struct GoldenFiles {
    /// File name patterns for drivers whose renderer string matches a glob; the longest matching glob is
    /// used.
    struct ForDriver {
        std::string driver; ///< "llvmpipe*"; "*" matches all, also the reference, whose driver is ""
        std::vector<std::string> patterns;
        bool operator==(const ForDriver&) const = default;
    };
    std::vector<ForDriver> drivers;
    bool operator==(const GoldenFiles&) const = default;
};
/// The reference's picture, compared by a rule (texplorer/conform/rule.h).
struct GoldenReference {
    /// ruleNames: "auto" is ruleFor's, "none" uses the criterion, as for a stored picture.
    std::string rule = "auto";
    bool operator==(const GoldenReference&) const = default;
};
using Golden = std::variant<GoldenFiles, GoldenReference>;

/// The settings of an entry; `defaults` of the suite has their defaults.
struct Settings {
    std::vector<PictureSize> sizes{PictureSize{}};
    std::vector<double> times{0}; ///< seconds
    std::vector<RendererKind> renderers{RendererKind::Fixed};
    Golden golden = GoldenFiles{{{"*", {"golden/{case}.png"}}}};
    Criterion criterion{}; ///< "metric", "tolerance", "share", "rgb", "pixelsPerDegree": for stored pictures
    std::string mask; ///< a picture, relative to the folder, whose black pixels are not compared; empty: none
    double seconds = 60; ///< the timeout of a case
    bool operator==(const Settings&) const = default;
};

struct Entry {
    std::string name; ///< empty: made from the scene
    std::vector<SceneSource> scenes{SceneFile{}};
    std::vector<Edit> edits;       ///< "set": for each of its scenes
    std::vector<std::string> axes; ///< "textures[0].wrapS=*": for parseSweepAxis
    Settings settings;
    bool operator==(const Entry&) const = default;
};

struct Suite {
    std::string name;             ///< "textures"
    std::string about;            ///< a sentence; may be empty
    std::filesystem::path folder; ///< file names are relative to it; empty: the current folder
    std::filesystem::path file{}; ///< the file that it was read from; empty: none
    std::vector<Entry> entries;
    bool operator==(const Suite&) const = default;
};

/// Parses a suite; does not access its folder. Errors, with the JSON pointer in Error::where: Malformed,
/// Unsupported, OutOfRange or TooLarge for invalid JSON (with a line), unknown keys (with the nearest known
/// one), wrong types, lists that are too long, files outside of the folder.
[[nodiscard]] Result<Suite> parseSuite(std::string_view json);

/// Reads a suite's file; its name defaults to the file's. Errors with the file in `where`.
[[nodiscard]] Result<Suite> readSuite(const std::filesystem::path& file);

/// A JSON Schema (draft 2020-12) of suites, for editors.
[[nodiscard]] std::string suiteSchema();

} // namespace texplorer::suite

#pragma once

// Lessons as values: the text of a step, its scene, its question. A lesson is a folder that a teacher can
// write with a text editor: lesson.json, with scenes, images and a catalogue of texts for each language
// (zh_CN.po) next to it.

#include "texplorer/base/result.h"
#include "texplorer/scene/edit/edit.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texplorer::lesson {

inline constexpr int lessonFormatVersion = 1;
inline constexpr std::size_t maxLessonBytes = std::size_t{1} << 20; ///< of lesson.json
inline constexpr std::size_t maxSteps = 100;
inline constexpr std::size_t maxEdits = 200; ///< of a list
inline constexpr std::size_t minAnswers = 2;
inline constexpr std::size_t maxAnswers = 4;
inline constexpr std::size_t maxKeys = 24;
inline constexpr std::size_t maxChoices = 8; ///< of a key

/// The values of Look::tab: the window's tabs, except those of the lesson and of the figures.
inline constexpr std::array<std::string_view, 10> lookTabs{
    "vertices", "levels", "commands", "glsl", "explain", "file", "memory", "a-b", "history", "timeline"};

/// The values of Look::figure: the figures of the window's tab of that name.
inline constexpr std::array<std::string_view, 9> lookFigures{
    "environments", "sheet", "block", "flip", "objects", "emboss", "edge", "upload", "cost"};

/// What the window shows for the step, with the names of texshot; empty members change nothing.
struct Look {
    std::string param;    ///< a path: its control is highlighted
    std::string tab;      ///< the tab to show
    std::string figure;   ///< the figure to show, with its tab
    std::string shown;    ///< the content of the view: picture, levels, anisotropy
    std::string renderer; ///< fixed, shader, reference; or two of them with a comma, to compare
    int probeX = -1;      ///< the pixel of the Explain tab, in thousandths of the picture from its left edge
    int probeY = -1;      ///< and from its top; -1: none

    bool operator==(const Look&) const = default;
};

/// Something to do, without a grade.
struct Try {
    std::string task;

    bool operator==(const Try&) const = default;
};

/// An answer to a question. An answer with edits is shown with its picture.
struct Answer {
    std::string text;
    std::vector<Edit> edits;

    bool operator==(const Answer&) const = default;
};

struct Predict {
    std::string question;
    std::vector<Answer> answers; ///< minAnswers to maxAnswers
    std::size_t right = 0;       ///< index of the right one
    std::string reason;          ///< why it is right

    bool operator==(const Predict&) const = default;
};

/// A picture to reach: that of the step's scene with these edits.
struct Match {
    std::string task;
    std::vector<Edit> edits;

    bool operator==(const Match&) const = default;
};

/// Used if the scene needs more texture units than the driver has.
struct Fallback {
    std::string text;        ///< explains the difference
    std::vector<Edit> edits; ///< made last

    bool operator==(const Fallback&) const = default;
};

/// A step of a lesson. Its texts may contain "{color}" and the other words of numbers.h for numbers of the
/// marked pixel.
struct Step {
    std::string title;
    std::string text;        ///< two or three sentences
    std::string scene;       ///< a file of the lesson, or an example's name; empty: that of the previous step
    std::vector<Edit> edits; ///< changes to it
    Look look;
    std::variant<std::monostate, Try, Predict, Match> task;
    std::optional<Fallback> fallback{}; ///< also used for later steps that continue with its scene

    bool operator==(const Step&) const = default;
};

/// One of the choices of a key.
struct KeyChoice {
    std::string label;
    std::vector<Edit> edits; ///< at least one

    bool operator==(const KeyChoice&) const = default;
};

/// Each press selects the next choice. If choices of several keys change the same parameters, all are applied
/// in the order of the keys, so a later key wins.
struct Cycle {
    std::vector<KeyChoice> choices; ///< at least one

    bool operator==(const Cycle&) const = default;
};

/// Adds to a number: once per press, and 60 times a second while the key is held, as in programs that test
/// their keys every frame.
struct Addition {
    std::string path;
    int component = 0; ///< of a vector: 0 to 3
    float amount = 0;

    bool operator==(const Addition&) const = default;
};

/// The action of a key while the lesson is open; it replaces the window's own shortcut. It has no effect in
/// steps whose scene lacks the parameters.
struct LessonKey {
    std::string key;   ///< one of keyNames, a letter or a digit
    std::string label; ///< "Filter"
    std::variant<Cycle, Addition> effect;

    bool operator==(const LessonKey&) const = default;
};

/// The values of LessonKey::key other than A to Z and 0 to 9.
inline constexpr std::array<std::string_view, 11> keyNames{
    "Up", "Down", "Left", "Right", "Page Up", "Page Down", "Home", "End", "Insert", "Delete", "Space"};

[[nodiscard]] bool isKeyName(std::string_view name);

/// The symbol of a key: an arrow, or its name.
[[nodiscard]] std::string_view signOfKey(std::string_view name);

struct Lesson {
    std::string title;
    std::string source;      ///< its source: a chapter of a book
    std::string about;       ///< a sentence or two
    std::vector<Step> steps; ///< at least one
    std::vector<LessonKey> keys{};

    bool operator==(const Lesson&) const = default;
};

/// Parses a lesson.json. Errors, with the JSON pointer in Error::where: Malformed, Unsupported, OutOfRange or
/// TooLarge for invalid JSON, unknown keys, missing or empty texts, a question without two to four answers,
/// more than one task, edits that are neither PATH=VALUE nor preset:NAME, unknown or duplicate keys. Whether
/// the edits are possible is checked by checkLesson.
[[nodiscard]] Result<Lesson> parseLesson(std::string_view json);

/// Returns every text that users read, in order, for a catalogue.
[[nodiscard]] std::vector<std::string> textsOf(const Lesson& lesson);
[[nodiscard]] std::vector<std::string> textsOf(const Step& step);

} // namespace texplorer::lesson

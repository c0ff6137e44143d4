#pragma once

// Lessons as values: what a step says, the scene that it begins with, what it asks. A lesson is a folder that
// a teacher can write with a text editor: lesson.json, scenes and images beside it, and a catalogue of texts
// for each language, zh_CN.po.

#include "core/base/result.h"

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
inline constexpr std::size_t fewestAnswers = 2;
inline constexpr std::size_t mostAnswers = 4;
inline constexpr std::size_t maxKeys = 24;
inline constexpr std::size_t maxChoices = 8; ///< that a key goes through

/// What changes a scene: "textures[0].wrapS=GL_CLAMP", or a preset, "preset:alpha-test".
struct Edit {
    std::string path; ///< empty: a preset
    std::string value;

    bool operator==(const Edit&) const = default;
};

/// What Look::tab may say: the window's tabs, but that of the lesson and that of the figures.
inline constexpr std::array<std::string_view, 10> lookTabs{
    "vertices", "levels", "commands", "glsl", "explain", "file", "memory", "a-b", "history", "timeline"};

/// What Look::figure may say: the figures of the window's tab of that name.
inline constexpr std::array<std::string_view, 7> lookFigures{"environments", "sheet",  "block", "flip",
                                                             "objects",      "emboss", "edge"};

/// What the window shows of the step, each as texshot has it; what is empty stays as it is.
struct Look {
    std::string param;    ///< a path: its control is lit
    std::string tab;      ///< comes to the front
    std::string figure;   ///< comes to the front with its tab
    std::string shown;    ///< what the view shows: picture, levels, anisotropy
    std::string renderer; ///< fixed, shader, reference; or two of them, joined by a comma, which are compared
    int probeX = -1; ///< the pixel that Explain is about, in thousandths of the picture from its left edge
    int probeY = -1; ///< and from its top; -1: none

    bool operator==(const Look&) const = default;
};

/// Something to do, at which nobody is graded.
struct Try {
    std::string task;

    bool operator==(const Try&) const = default;
};

/// What the scene would be. Where an answer has edits, its picture stands beside it.
struct Answer {
    std::string text;
    std::vector<Edit> edits;

    bool operator==(const Answer&) const = default;
};

struct Predict {
    std::string question;
    std::vector<Answer> answers; ///< fewestAnswers to mostAnswers
    std::size_t right = 0;       ///< which of them is
    std::string reason;          ///< why

    bool operator==(const Predict&) const = default;
};

/// A picture to reach: that of the step's scene with these edits.
struct Match {
    std::string task;
    std::vector<Edit> edits;

    bool operator==(const Match&) const = default;
};

/// How a scene is drawn where it uses more texture units than there are.
struct Fallback {
    std::string text;        ///< says so
    std::vector<Edit> edits; ///< made last

    bool operator==(const Fallback&) const = default;
};

/// In its texts "{color}" and the other words of numbers.h stand for numbers of the pixel that it probes.
struct Step {
    std::string title;
    std::string text;        ///< two or three sentences
    std::string scene;       ///< a file of the lesson, or an example's name; empty: that of the step before
    std::vector<Edit> edits; ///< made to it
    Look look;
    std::variant<std::monostate, Try, Predict, Match> task;
    std::optional<Fallback> fallback{}; ///< also of the steps that go on with its scene

    bool operator==(const Step&) const = default;
};

/// One of what a key goes through.
struct KeyChoice {
    std::string label;
    std::vector<Edit> edits; ///< at least one

    bool operator==(const KeyChoice&) const = default;
};

/// Each press goes on to the next choice. Where the choices of several keys change the same parameters, they
/// are all made, in the order of the keys: a later key has the last word.
struct Cycle {
    std::vector<KeyChoice> choices; ///< at least one

    bool operator==(const Cycle&) const = default;
};

/// Adds to a number: once when it is pressed, and 60 times a second while it is held, as programs do that
/// look at their keys in every frame.
struct Addition {
    std::string path;
    int component = 0; ///< of a vector: 0 to 3
    float amount = 0;

    bool operator==(const Addition&) const = default;
};

/// What a key does while the lesson is open, in the place of the window's own shortcut. In a step whose scene
/// hasn't the parameters it does nothing.
struct LessonKey {
    std::string key;   ///< one of keyNames, or a letter or digit
    std::string label; ///< "Filter"
    std::variant<Cycle, Addition> effect;

    bool operator==(const LessonKey&) const = default;
};

/// What LessonKey::key may say, beside A to Z and 0 to 9.
inline constexpr std::array<std::string_view, 11> keyNames{
    "Up", "Down", "Left", "Right", "Page Up", "Page Down", "Home", "End", "Insert", "Delete", "Space"};

[[nodiscard]] bool isKeyName(std::string_view name);

/// What stands on a key: an arrow, or its name.
[[nodiscard]] std::string_view signOfKey(std::string_view name);

struct Lesson {
    std::string title;
    std::string source;      ///< what it is about: a book's chapter
    std::string about;       ///< a sentence or two
    std::vector<Step> steps; ///< at least one
    std::vector<LessonKey> keys{};

    bool operator==(const Lesson&) const = default;
};

/// Reads a lesson.json. Malformed, Unsupported, OutOfRange or TooLarge, with the JSON pointer in
/// Error::where: no JSON, unknown keys, missing or empty texts, a question without two to four answers, more
/// than one task, edits that are neither PATH=VALUE nor preset:NAME, keys that there aren't or that are there
/// twice. Whether edits can be made, checkLesson says.
[[nodiscard]] Result<Lesson> parseLesson(std::string_view json);

/// Every text that a reader sees, in order, for a catalogue.
[[nodiscard]] std::vector<std::string> textsOf(const Lesson& lesson);
[[nodiscard]] std::vector<std::string> textsOf(const Step& step);

} // namespace texplorer::lesson

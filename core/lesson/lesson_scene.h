#pragma once

#include "core/lesson/lesson.h"
#include "core/lesson/lesson_files.h"
#include "core/texture/image_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texplorer::lesson {

/// A picture of installedImages that a scene names.
struct InstalledImage {
    std::string name;                ///< "earth.jpg"
    std::filesystem::path path = {}; ///< where it was read; empty: it is not there, and a pattern is

    bool operator==(const InstalledImage&) const = default;
};

/// A scene with its images, as a document begins.
struct LessonScene {
    Scene scene;
    ImageSource images;
    std::vector<InstalledImage> installed = {};
    std::string fallback = {}; ///< the step's fallback says so; empty: it isn't needed, or there is none
};

/// A picture's width and height in pixels.
struct PictureSize {
    int width = 0;
    int height = 0;

    bool operator==(const PictureSize&) const = default;
};

/// Where its photographs are from, or that others stand for them: a sentence each.
[[nodiscard]] std::vector<std::string> imageNotes(const LessonScene& step);

enum class StepImages : bool { Read, Leave };

/// What a step begins with: the scene that it names, or the step before it begins with, with its edits; where
/// that uses more than `units` texture units, with those of the fallback. A texture whose file is one of
/// installedImages has it where it is installed, without a preparation; elsewhere it has its pattern instead,
/// with its preparation. Errors are about lesson.json, by its JSON pointer, or the files that it names.
/// Images on the disk may be left to be read later: they are where they may be, then, and are perhaps not
/// there.
[[nodiscard]] Result<LessonScene> startOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step,
                                          StepImages images = StepImages::Read, int units = maxUnits);

/// How many texture units a scene needs: one more than the last that is enabled in a pass that is drawn.
[[nodiscard]] int unitsUsed(const Scene& scene);

/// Makes all edits, or none. The error's `where` is "edits/3", after it that of setParam.
[[nodiscard]] Result<void> makeEdits(Scene& scene, const std::vector<Edit>& edits);

/// What an answer, or the picture to reach, is of: the step's scene with these edits.
[[nodiscard]] Result<LessonScene> withEdits(const LessonScene& start, const std::vector<Edit>& edits);

} // namespace texplorer::lesson

#pragma once

#include "texplorer/lesson/lesson.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/texture/image_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texplorer::lesson {

/// A picture of installedImages in a scene.
struct InstalledImage {
    std::string name;                ///< "earth.jpg"
    std::filesystem::path path = {}; ///< the file; empty: not installed, a pattern is used

    bool operator==(const InstalledImage&) const = default;
};

/// A scene with its images, to start a document.
struct LessonScene {
    Scene scene;
    ImageSource images;
    std::vector<InstalledImage> installed = {};
    std::string fallback = {}; ///< the text of the step's fallback; empty: not needed, or none
};

/// Width and height of a picture in pixels.
struct PictureSize {
    int width = 0;
    int height = 0;

    bool operator==(const PictureSize&) const = default;
};

/// A sentence for each photograph: its source, or that a pattern replaces it.
[[nodiscard]] std::vector<Sentence> imageNotes(const LessonScene& step);

enum class StepImages : bool { Read, Leave };

/// Returns the start of a step: its scene, or that of the previous step, with its edits; with those of the
/// fallback if it needs more than `units` texture units. A texture whose file is one of installedImages uses
/// the installed file without preparation; if that is missing, its pattern with its preparation. Errors refer
/// to lesson.json by JSON pointer, or to the files. Images on disk can be loaded later; until then, their
/// paths are unchecked.
[[nodiscard]] Result<LessonScene> startOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step,
                                          StepImages images = StepImages::Read, int units = maxUnits);

/// The number of texture units that a scene needs: one more than the last unit that is enabled in a drawn
/// pass.
[[nodiscard]] int unitsUsed(const Scene& scene);

/// Returns the scene of an answer, or of the picture to reach: the step's scene with these edits.
[[nodiscard]] Result<LessonScene> withEdits(const LessonScene& start, const std::vector<Edit>& edits);

} // namespace texplorer::lesson

#pragma once

#include "app/ui/model/session.h"
#include "texplorer/lesson/lesson_files.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// Opens a lesson at its last shown step and replaces the scene: see askLesson. Errors: those of readLesson
/// and startOf; nothing has changed then. Images of a folder arrive later, as for any scene.
[[nodiscard]] Result<void> openLesson(Session& session, const lesson::LessonFolder& folder,
                                      std::optional<std::size_t> step = {});

/// Opens a built-in lesson or a folder's. Errors: those of LessonFolder::builtIn and openLesson.
[[nodiscard]] Result<void> openLessonNamed(Session& session, const std::string& nameOrFolder,
                                           std::optional<std::size_t> step = {});

/// Shows another step, or restarts the current one.
void goToLessonStep(Session& session, std::size_t step);

/// The student's answer. The right one shows its scene, and later the reason.
void answerQuestion(Session& session, std::size_t answer);

/// Where a lesson is shown: the picture in the view, and the driver.
struct LessonPlace {
    lesson::PictureSize picture;
    int units = maxUnits; ///< the number of the driver's texture units
};

/// Call once per frame. Takes finished results, and requests the grade of a changed scene, a wanted hint, and
/// the numbers of another picture. Restarts the step if the driver turns out to have fewer texture units.
void followLesson(Session& session, const LessonPlace& place);

/// Reads a lesson's folder again after its files have changed; the shown step stays. If a file cannot be read
/// or is invalid, nothing changes and the user gets a message.
void reloadLesson(Session& session);

} // namespace texplorer::ui

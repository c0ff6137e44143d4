#pragma once

#include "core/lesson/lesson_scene.h"

#include <string>
#include <string_view>

namespace texplorer::lesson {

/// The words that stand for numbers in a reason: {color} the pixel's bytes, {s} {t} its coordinates, {level}
/// the levels that it reads, {lambda}, {rho}, {texel} the filtered colour, {texels} how many were read,
/// {fragment} what lighting or glColor gave. Malformed: another word.
[[nodiscard]] Result<void> checkReason(std::string_view reason);

/// The reason with the numbers of a pixel, in thousandths of the picture from its top left. Where there is
/// none, or nothing is drawn there, a dash stands in its place.
[[nodiscard]] Result<std::string> reasonOf(std::string_view reason, const LessonScene& scene, int x, int y);

} // namespace texplorer::lesson

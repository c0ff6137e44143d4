#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/lesson/lesson.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::lesson {

/// A file of assets/lessons, embedded in the program: "wrap/lesson.json", "dds/dxt1.dds".
struct LessonFile {
    std::string_view name;
    std::string_view text; ///< the text, or the bytes of an image
};
[[nodiscard]] const std::vector<LessonFile>& lessonFiles();

/// The file that makes a folder a lesson.
inline constexpr std::string_view lessonFileName = "lesson.json";

/// The largest image of a lesson.
inline constexpr std::size_t maxLessonFileBytes = std::size_t{32} << 20;
/// The largest scene or catalogue; these are read while the window waits.
inline constexpr std::size_t maxLessonTextBytes = std::size_t{8} << 20;

/// The folder of installedImages in Debian's package xplanet-images.
inline constexpr std::string_view installedImageFolder = "/usr/share/xplanet/images";
/// Photographs that are too large to embed. Scenes of built-in lessons can use them from the installed
/// package; other lessons cannot.
inline constexpr std::array<std::string_view, 2> installedImages{"earth.jpg", "night.jpg"};

/// The files of a lesson, embedded in the program or in a folder.
class LessonFolder {
public:
    /// A built-in lesson. Error: NotFound, with the existing names. `installed` is the folder of
    /// installedImages, if they are installed.
    [[nodiscard]] static Result<LessonFolder> builtIn(std::string_view name,
                                                      std::filesystem::path installed = installedImageFolder);

    /// Any folder; nothing is read yet.
    [[nodiscard]] static LessonFolder onDisk(std::filesystem::path folder);

    [[nodiscard]] const std::string& name() const { return name_; }

    /// Empty for a built-in lesson.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    [[nodiscard]] bool has(std::string_view file) const;

    /// How a file of the folder is named in errors: "bricks/lesson.json".
    [[nodiscard]] std::string placeOf(std::string_view file) const;

    /// The path of a file of installedImages; empty for a folder on disk.
    [[nodiscard]] std::filesystem::path installed(std::string_view file) const;

    /// Checks that a name is a file in the folder itself: OutOfRange if it leads out of the folder, also by a
    /// link. The file need not exist.
    [[nodiscard]] Result<void> checkInside(std::string_view file) const;

    /// Reads a file of the folder by its name. Errors: OutOfRange for a name that leads out of the folder,
    /// also by a link; NotFound, Unreadable, TooLarge. `where` is the file.
    [[nodiscard]] Result<Bytes> read(std::string_view file, std::size_t maxBytes = maxLessonFileBytes) const;
    [[nodiscard]] Result<std::string> readText(std::string_view file) const;

private:
    LessonFolder() = default;

    std::string name_;
    std::filesystem::path path_;
    std::filesystem::path installed_;
};

/// The names of the built-in lessons, in teaching order.
[[nodiscard]] std::vector<std::string> builtInLessons();

/// Reads lesson.json of a folder. Errors: those of LessonFolder::read and parseLesson, with the file in
/// `where`.
[[nodiscard]] Result<Lesson> readLesson(const LessonFolder& folder);

} // namespace texplorer::lesson

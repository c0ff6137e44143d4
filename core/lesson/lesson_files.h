#pragma once

#include "core/base/bytes.h"
#include "core/lesson/lesson.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::lesson {

/// A file of assets/lessons, which is part of the program: "wrap/lesson.json", "dds/dxt1.dds".
struct LessonFile {
    std::string_view name;
    std::string_view text; ///< of an image its bytes
};
[[nodiscard]] const std::vector<LessonFile>& lessonFiles();

/// The file that makes a folder a lesson.
inline constexpr std::string_view lessonFileName = "lesson.json";

/// The longest image of a lesson.
inline constexpr std::size_t maxLessonFileBytes = std::size_t{32} << 20;
/// The longest scene or catalogue, which are read while the window waits.
inline constexpr std::size_t maxLessonTextBytes = std::size_t{8} << 20;

/// Where Debian's package xplanet-images has the pictures of installedImages.
inline constexpr std::string_view installedImageFolder = "/usr/share/xplanet/images";
/// Photographs that are too large to come with the program. A lesson's scene may name them: those of the
/// program take them from there, and nobody else's do.
inline constexpr std::array<std::string_view, 2> installedImages{"earth.jpg", "night.jpg"};

/// Where a lesson's files are: in the program, or in a folder.
class LessonFolder {
public:
    /// One of the program's own. NotFound, with the names that there are. `installed` is where
    /// installedImages are, if they are there.
    [[nodiscard]] static Result<LessonFolder> builtIn(std::string_view name,
                                                      std::filesystem::path installed = installedImageFolder);

    /// Any folder; nothing is read yet.
    [[nodiscard]] static LessonFolder onDisk(std::filesystem::path folder);

    [[nodiscard]] const std::string& name() const { return name_; }

    /// Empty: in the program.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    [[nodiscard]] bool has(std::string_view file) const;

    /// Where a file of installedImages would be; empty: nowhere, for a folder on disk has its own.
    [[nodiscard]] std::filesystem::path installed(std::string_view file) const;

    /// Whether a name is that of a file in the folder itself: OutOfRange for one that leads out of it, as a
    /// link may do, too. The file need not be there.
    [[nodiscard]] Result<void> checkInside(std::string_view file) const;

    /// A file of the folder, by its name alone. Errors: OutOfRange for a name that leads out of the folder,
    /// as a link may do, too; NotFound, Unreadable, TooLarge. `where` is the file.
    [[nodiscard]] Result<Bytes> read(std::string_view file, std::size_t most = maxLessonFileBytes) const;
    [[nodiscard]] Result<std::string> readText(std::string_view file) const;

private:
    LessonFolder() = default;

    std::string name_;
    std::filesystem::path path_;
    std::filesystem::path installed_;
};

/// The program's lessons, in the order in which they are taught.
[[nodiscard]] std::vector<std::string> builtInLessons();

/// lesson.json of a folder. Errors: those of LessonFolder::read and parseLesson, with the file in `where`.
[[nodiscard]] Result<Lesson> readLesson(const LessonFolder& folder);

} // namespace texplorer::lesson

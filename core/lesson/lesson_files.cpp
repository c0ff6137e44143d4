#include "texplorer/lesson/lesson_files.h"

#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/nearest_name.h"

#include <algorithm>
#include <array>

namespace texplorer::lesson {
namespace {

namespace fs = std::filesystem;

/// The order in which they are taught: each needs what those before it explain. What isn't named here comes
/// last.
constexpr std::array order{"first-texture", "coordinates", "wrap",      "filters", "mipmaps", "environments",
                           "light",         "alpha",       "objects",   "matrix",  "texgen",  "textured-cube",
                           "dds",           "blocks",      "sizes",     "lines",   "volumes", "combine",
                           "bumps",         "earth",       "laboratory"};

const LessonFile* findLessonFile(const std::string& name) {
    const auto found = std::ranges::find(lessonFiles(), name, &LessonFile::name);
    return found == lessonFiles().end() ? nullptr : &*found;
}

std::size_t placeInOrder(const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(order, name) - order.begin());
}

Error outside(std::string_view file) {
    return {ErrorCode::OutOfRange, N_("expected the name of a file in the lesson's folder"),
            inFile(std::string(file))};
}

} // namespace

std::vector<std::string> builtInLessons() {
    std::vector<std::string> names;
    for (const LessonFile& file : lessonFiles()) {
        const std::size_t slash = file.name.find('/');
        if (file.name.substr(slash + 1) == lessonFileName)
            names.emplace_back(file.name.substr(0, slash));
    }
    std::ranges::sort(names);
    std::ranges::stable_sort(names, {}, placeInOrder);
    return names;
}

Result<LessonFolder> LessonFolder::builtIn(std::string_view name, fs::path installed) {
    const std::vector<std::string> names = builtInLessons();
    if (std::ranges::find(names, name) == names.end()) {
        const std::string given = shortened(name);
        const std::string_view near = nearestName(given, {names.begin(), names.end()});
        std::string list;
        for (const std::string& each : names)
            list += (list.empty() ? "" : ", ") + each;
        return fail(ErrorCode::NotFound,
                    near.empty()
                        ? Sentence("expected one of {0}, found \"{1}\"", ProperName{list}, ProperName{given})
                        : Sentence("there is no lesson \"{0}\"; did you mean \"{1}\"?", ProperName{given},
                                   ProperName{near}));
    }
    LessonFolder folder;
    folder.name_ = name;
    folder.installed_ = std::move(installed);
    return folder;
}

LessonFolder LessonFolder::onDisk(fs::path path) {
    LessonFolder folder;
    const fs::path whole = path.has_filename() ? path : path.parent_path();
    folder.name_ = whole.filename().string();
    folder.path_ = path.empty() ? fs::path(".") : std::move(path);
    return folder;
}

bool LessonFolder::has(std::string_view file) const {
    std::error_code ignored;
    return path_.empty() ? findLessonFile(name_ + "/" + std::string(file)) != nullptr
                         : fs::exists(fs::symlink_status(path_ / file, ignored)); // reading says what it is
}

std::string LessonFolder::placeOf(std::string_view file) const {
    return ((path_.empty() ? fs::path(name_) : path_) / file).string();
}

fs::path LessonFolder::installed(std::string_view file) const {
    const bool isKnown = std::ranges::find(installedImages, file) != installedImages.end();
    return isKnown && !installed_.empty() ? installed_ / file : fs::path();
}

Result<void> LessonFolder::checkInside(std::string_view file) const {
    const fs::path name(file);
    if (name.empty() || name.has_parent_path() || name == ".." || name == ".")
        return fail(outside(file));
    std::error_code failed;
    const fs::path whole = path_ / name;
    if (path_.empty() || !fs::is_symlink(fs::symlink_status(whole, failed)))
        return {};
    const fs::path target = fs::canonical(whole, failed);
    if (failed || target.parent_path() != fs::canonical(path_, failed))
        return fail(outside(file));
    return {};
}

Result<Bytes> LessonFolder::read(std::string_view file, std::size_t maxBytes) const {
    if (const Result<void> inside = checkInside(file); !inside)
        return fail(inside.error());
    if (!path_.empty())
        return readFile(path_ / file, maxBytes);
    const LessonFile* found = findLessonFile(name_ + "/" + std::string(file));
    if (!found)
        return fail(ErrorCode::NotFound, "the lesson has no such file", inFile(std::string(file)));
    const ByteView bytes = viewBytes(found->text);
    return Bytes(bytes.begin(), bytes.end());
}

Result<std::string> LessonFolder::readText(std::string_view file) const {
    return read(file, maxLessonTextBytes).map([](const Bytes& bytes) {
        return std::string(reinterpret_cast<const char*>(bytes.data()),
                           bytes.size()); // NOLINT: bytes of a text
    });
}

Result<Lesson> readLesson(const LessonFolder& folder) {
    const Result<std::string> text = folder.readText(lessonFileName);
    if (!text)
        return fail(text.error());
    Result<Lesson> lesson = parseLesson(*text);
    return lesson ? lesson : fail(within(inFile(folder.placeOf(lessonFileName)), lesson.error()));
}

} // namespace texplorer::lesson

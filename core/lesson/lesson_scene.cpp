#include "core/lesson/lesson_scene.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/example/example.h"
#include "core/lesson/lesson_keys.h"
#include "core/lesson/match.h"
#include "core/lesson/reason.h"
#include "core/preset/preset.h"
#include "core/reference/false_colors.h"
#include "core/scene/params/json.h"
#include "core/scene/params/param_text.h"
#include "core/scene/params/params.h"
#include "core/scene/renderer.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

namespace texplorer::lesson {
namespace {

std::string placeOf(std::size_t step) {
    return fmt::format("/steps/{}", step);
}

Error at(const std::string& place, const Error& error) {
    return {error.code, error.message,
            error.where.empty() ? place : fmt::format("{}: {}", place, error.where)};
}

Result<Scene> sceneNamed(const LessonFolder& folder, const std::string& name) {
    if (folder.has(name)) {
        const Result<std::string> text = folder.readText(name);
        return text ? parseScene(*text) : Result<Scene>(fail(text.error()));
    }
    Result<Scene> example = exampleScene(name + ".json");
    if (!example && example.error().code == ErrorCode::NotFound)
        return fail(ErrorCode::NotFound,
                    fmt::format("expected a scene in the lesson's folder or the name of an example, found {}",
                                inQuotes(name)));
    return example;
}

/// A photograph where it is installed, a pattern where it isn't. One that can't be read is as good as none.
void takeInstalled(const LessonFolder& folder, LessonScene& step, StepImages images) {
    for (Texture& texture : step.scene.textures) {
        const std::string name = texture.file;
        if (texture.source != SourceKind::File || folder.has(name) ||
            std::ranges::find(installedImages, name) == installedImages.end())
            continue;
        const std::filesystem::path path = folder.installed(name);
        std::error_code ignored;
        bool isThere = !path.empty() && std::filesystem::is_regular_file(path, ignored);
        if (isThere && images == StepImages::Read) {
            Result<TextureImage> image = readFile(path, maxLessonFileBytes).and_then([](const Bytes& bytes) {
                return decodeTexture(bytes);
            });
            isThere = image.has_value();
            if (image)
                step.images.put(path.string(), *std::move(image));
        }
        step.installed.push_back({name, isThere ? path : std::filesystem::path()});
        if (isThere) {
            texture.file = path.string();
            texture.preparation.clear();
        } else {
            texture.source = SourceKind::Pattern;
            texture.file.clear();
        }
    }
}

/// Files of the program's own lesson.
Result<void> takeEmbedded(const LessonFolder& folder, LessonScene& step) {
    for (const std::string& file : filesOf(step.scene)) {
        const bool isInstalled = std::ranges::any_of(
            step.installed, [&](const InstalledImage& each) { return each.path == file; });
        if (isInstalled)
            continue;
        Result<Bytes> bytes = folder.read(file);
        if (!bytes)
            return fail(bytes.error());
        Result<TextureImage> image = decodeTexture(*bytes);
        if (!image)
            return fail(image.error().code, image.error().message, file);
        step.images.put(file, *std::move(image));
        step.images.putFile(file, *std::move(bytes));
    }
    return {};
}

/// Files that stand in the folder, of the program's own lessons and of a teacher's. None may lie elsewhere.
Result<void> loadImages(const LessonFolder& folder, LessonScene& step, StepImages images) {
    takeInstalled(folder, step, images);
    if (folder.path().empty())
        return takeEmbedded(folder, step);
    for (const std::string& file : filesOf(step.scene)) {
        if (const Result<void> inside = file.empty() ? Result<void>() : folder.checkInside(file); !inside)
            return inside;
    }
    return images == StepImages::Read ? step.images.load(step.scene) : Result<void>();
}

/// The scene that a step names, or the nearest before it, and what the steps since then have edited.
Result<LessonScene> sceneOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step) {
    const Step& here = lesson.steps[step];
    if (here.scene.empty() && step > 0)
        return sceneOf(folder, lesson, step - 1).and_then([&](LessonScene before) -> Result<LessonScene> {
            if (const Result<void> made = makeEdits(before.scene, here.edits); !made)
                return fail(at(placeOf(step), made.error()));
            return before;
        });
    Result<Scene> scene = sceneNamed(folder, here.scene);
    if (!scene)
        return fail(at(placeOf(step) + "/scene", scene.error()));
    LessonScene start{*std::move(scene), ImageSource{folder.path()}};
    if (const Result<void> made = makeEdits(start.scene, here.edits); !made)
        return fail(at(placeOf(step), made.error()));
    return start;
}

using Problems = std::vector<Error>;

/// With edits that change the scene, and name no file that the step hasn't loaded.
Result<LessonScene> checkedEdits(const LessonScene& start, const std::vector<Edit>& edits) {
    Result<LessonScene> scene = withEdits(start, edits);
    if (!scene)
        return scene;
    for (const std::string& file : filesOf(scene->scene)) {
        if (!scene->images.holds(file))
            return fail(ErrorCode::NotFound, "the step's own scene has no such image", file);
    }
    return scene;
}

/// A name of a table that the window would pass over.
template<class Rows, class NameOf>
void checkName(std::string_view name, const Rows& rows, const NameOf& nameOf, const std::string& where,
               Problems& problems) {
    std::string names;
    for (const auto& row : rows) {
        if (name == nameOf(row))
            return;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", nameOf(row));
    }
    problems.push_back(
        {ErrorCode::NotFound, fmt::format("expected one of {}, found {}", names, inQuotes(name)), where});
}

void checkLook(const Look& look, const Scene& scene, const std::string& place, Problems& problems) {
    const auto rowName = [](const EnumRow& row) { return row.name; };
    if (!look.param.empty()) {
        if (const Result<std::string> value = getParam(scene, look.param); !value)
            problems.push_back(at(place + "/param", value.error()));
    }
    if (!look.tab.empty())
        checkName(look.tab, lookTabs, std::identity{}, place + "/tab", problems);
    if (!look.figure.empty())
        checkName(look.figure, lookFigures, std::identity{}, place + "/figure", problems);
    if (!look.shown.empty())
        checkName(look.shown, EnumTable<reference::Shown>::rows, rowName, place + "/shown", problems);
    for (std::size_t from = 0; from < look.renderer.size();) {
        const std::size_t end = std::min(look.renderer.find(',', from), look.renderer.size());
        checkName(look.renderer.substr(from, end - from), EnumTable<RendererKind>::rows, rowName,
                  place + "/renderer", problems);
        from = end + 1;
    }
}

void checkTask(const Predict& predict, const LessonScene& start, const std::string& place,
               Problems& problems) {
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        const std::vector<Edit>& edits = predict.answers[i].edits;
        if (edits.empty())
            continue;
        const std::string where = fmt::format("{}/predict/answers/{}", place, i);
        const Result<LessonScene> scene = checkedEdits(start, edits);
        if (!scene) {
            problems.push_back(at(where, scene.error()));
            continue;
        }
        Result<Image> picture = drawSmall(*scene);
        if (!picture)
            problems.push_back(at(where, picture.error()));
        else if (std::ranges::any_of(pictures, [&](const Image& other) { return areAlike(other, *picture); }))
            problems.push_back(
                {ErrorCode::Malformed, "its picture can't be told from that of another answer", where});
        else
            pictures.push_back(*std::move(picture));
    }
    if (const Result<void> words = checkReason(predict.reason); !words)
        problems.push_back(at(place + "/predict/reason", words.error()));
}

void checkTask(const Match& match, const LessonScene& start, const std::string& place, Problems& problems) {
    const std::string where = place + "/match";
    const Result<LessonScene> target = checkedEdits(start, match.edits);
    if (!target)
        return problems.push_back(at(where, target.error()));
    const Result<Grade> grade = gradeMatch(start.scene, target->scene, start.images);
    if (!grade)
        problems.push_back(at(where, grade.error()));
    else if (grade->passed)
        problems.push_back({ErrorCode::Malformed, "its picture is that of the step's own scene", where});
}

/// Each has to do something in one step at least.
void checkKeys(const std::vector<LessonKey>& keys, const std::vector<Scene>& starts, Problems& problems) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Result<void> last;
        const bool works = std::ranges::any_of(starts, [&](const Scene& scene) {
            last = checkKey(scene, keys[i]);
            return last.has_value();
        });
        if (!works && !last)
            problems.push_back(at(fmt::format("/keys/{}", i), last.error()));
    }
}

void checkTask(const Try&, const LessonScene&, const std::string&, Problems&) {}
void checkTask(const std::monostate&, const LessonScene&, const std::string&, Problems&) {}

} // namespace

std::vector<std::string> imageNotes(const LessonScene& step) {
    std::string folder;
    std::string found;
    std::string missing;
    for (const InstalledImage& each : step.installed) {
        std::string& names = each.path.empty() ? missing : found;
        if (names.find(each.name) == std::string::npos)
            names += (names.empty() ? "" : ", ") + each.name;
        if (!each.path.empty())
            folder = each.path.parent_path().string();
    }
    std::vector<std::string> notes;
    if (!found.empty())
        notes.push_back(fmt::format("Photographs of {}: {}.", folder, found));
    if (!missing.empty())
        notes.push_back(fmt::format(
            "Computed pictures stand for {}, which Debian's package xplanet-images would have.", missing));
    return notes;
}

Result<void> makeEdits(Scene& scene, const std::vector<Edit>& edits) {
    Scene edited = scene;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const Edit& edit = edits[i];
        const Preset* preset = edit.path.empty() ? findPreset(edit.value) : nullptr;
        const Result<void> made =
            !edit.path.empty() ? setParam(edited, edit.path, edit.value)
            : preset           ? applyPreset(*preset, edited)
                     : Result<void>(fail(ErrorCode::NotFound, "there is no such preset", edit.value));
        if (!made)
            return fail(at(fmt::format("edits/{}", i), made.error()));
    }
    scene = std::move(edited);
    return {};
}

Result<LessonScene> withEdits(const LessonScene& start, const std::vector<Edit>& edits) {
    LessonScene scene = start;
    if (const Result<void> made = makeEdits(scene.scene, edits); !made)
        return fail(made.error());
    return scene;
}

Result<LessonScene> startOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step,
                            StepImages images) {
    Result<LessonScene> start = sceneOf(folder, lesson, step);
    if (!start)
        return start;
    if (const Result<void> loaded = loadImages(folder, *start, images); !loaded)
        return fail(at(placeOf(step) + "/scene", loaded.error()));
    return start;
}

Problems checkLesson(const LessonFolder& folder, const Lesson& lesson) {
    Problems problems;
    std::vector<Scene> starts;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Step& step = lesson.steps[i];
        const Result<LessonScene> start = startOf(folder, lesson, i);
        if (!start) {
            problems.push_back(start.error());
            continue;
        }
        const std::string place = placeOf(i);
        checkLook(step.look, start->scene, place + "/look", problems);
        std::visit([&](const auto& task) { checkTask(task, *start, place, problems); }, step.task);
        starts.push_back(start->scene);
    }
    checkKeys(lesson.keys, starts, problems);
    return problems;
}

} // namespace texplorer::lesson

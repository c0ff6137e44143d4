#include "texplorer/lesson/lesson_scene.h"

#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/lesson/lesson_place.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"

#include <algorithm>

namespace texplorer::lesson {
namespace {

Result<Scene> sceneNamed(const LessonFolder& folder, const std::string& name) {
    if (folder.has(name)) {
        const Result<std::string> text = folder.readText(name);
        if (!text)
            return fail(text.error());
        Result<Scene> scene = parseScene(*text);
        return scene ? scene : fail(within(inFile(folder.placeOf(name)), scene.error()));
    }
    Result<Scene> example = exampleScene(name + ".json");
    if (!example && example.error().code == ErrorCode::NotFound)
        return fail(ErrorCode::NotFound,
                    Sentence("expected a scene in the lesson's folder or the name of an example, found {0}",
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
        const auto refuse = [&](const Error& error) {
            return fail(error.code, error.message, inFile(folder.placeOf(file)));
        };
        if (isObjName(file)) {
            Result<MeshFile> meshes = meshFileIn(*bytes, {});
            if (!meshes)
                return refuse(meshes.error());
            step.images.put(file, std::make_shared<const MeshFile>(*std::move(meshes)));
        } else {
            Result<TextureImage> image = decodeTexture(*bytes);
            if (!image)
                return refuse(image.error());
            step.images.put(file, *std::move(image));
        }
        step.images.putFile(file, *std::move(bytes));
    }
    step.images.fillMeshes(step.scene);
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

/// The scene that a step names, or the nearest before it, and what the steps since then have edited. Its
/// fallback is that of the step that names it, or of one that goes on with it.
struct FoundScene {
    Scene scene;
    const Fallback* fallback;
    std::size_t step; ///< whose fallback it is
};

Result<FoundScene> sceneOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step) {
    const Step& here = lesson.steps[step];
    const auto begin = [&]() -> Result<FoundScene> {
        if (here.scene.empty() && step > 0)
            return sceneOf(folder, lesson, step - 1);
        Result<Scene> scene = sceneNamed(folder, here.scene);
        if (!scene)
            return fail(at(placeOf(step) + "/scene", scene.error()));
        return FoundScene{*std::move(scene), nullptr, step};
    };
    Result<FoundScene> found = begin();
    if (!found)
        return found;
    if (const Result<void> made = makeEdits(found->scene, here.edits, "/edits"); !made)
        return fail(at(placeOf(step), made.error()));
    if (here.fallback) {
        found->fallback = &*here.fallback;
        found->step = step;
    }
    return found;
}

} // namespace

std::vector<Sentence> imageNotes(const LessonScene& step) {
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
    std::vector<Sentence> notes;
    if (!found.empty())
        notes.push_back(Sentence("Photographs of {0}: {1}.", ProperName{folder}, ProperName{found}));
    if (!missing.empty())
        notes.push_back(
            Sentence("Computed pictures replace {0}, which Debian's package xplanet-images contains.",
                     ProperName{missing}));
    return notes;
}

Result<LessonScene> withEdits(const LessonScene& start, const std::vector<Edit>& edits) {
    LessonScene scene = start;
    if (const Result<void> made = makeEdits(scene.scene, edits, "/edits"); !made)
        return fail(made.error());
    return scene;
}

int unitsUsed(const Scene& scene) {
    int used = 0;
    for (const Pass& pass : scene.passes) {
        for (int unit = 0; pass.enabled && unit < maxUnits; ++unit) {
            if (pass.units[static_cast<std::size_t>(unit)].enabled)
                used = std::max(used, unit + 1);
        }
    }
    return used;
}

Result<LessonScene> startOf(const LessonFolder& folder, const Lesson& lesson, std::size_t step,
                            StepImages images, int units) {
    Result<FoundScene> found = sceneOf(folder, lesson, step);
    if (!found)
        return fail(found.error());
    LessonScene start{std::move(found->scene), ImageSource{folder.path()}};
    if (found->fallback && unitsUsed(start.scene) > units) {
        if (const Result<void> made = makeEdits(start.scene, found->fallback->edits, "/edits"); !made)
            return fail(at(placeOf(found->step) + "/fallback", made.error()));
        start.fallback = found->fallback->text;
    }
    if (const Result<void> loaded = loadImages(folder, start, images); !loaded)
        return fail(at(placeOf(step) + "/scene", loaded.error()));
    return start;
}

} // namespace texplorer::lesson

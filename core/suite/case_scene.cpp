#include "texplorer/suite/case_scene.h"

#include "texplorer/files/file_fingerprint.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/suite/case_name.h"
#include "texplorer/suite/hash.h"
#include "texplorer/suite/suite_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

namespace texplorer::suite {
namespace {

namespace fs = std::filesystem;

Result<CaseScene> openSource(const Suite& suite, const SceneFile& source) {
    if (source.file.empty())
        return CaseScene{defaultScene(), ImageSource{suite.folder}};
    const Result<fs::path> file = pathInside(suite.folder, source.file);
    if (!file)
        return fail(file.error());
    const Result<std::string> text = readText(*file, maxSceneBytes);
    if (!text)
        return fail(text.error());
    Result<Scene> scene = parseScene(*text);
    if (!scene) // NotFound is for the file itself
        return fail(within(inFile(file->string()),
                           {ErrorCode::Malformed, scene.error().message, scene.error().where}));
    return CaseScene{*std::move(scene), ImageSource{file->parent_path()}, *file};
}

Result<CaseScene> openSource(const Suite& suite, const SceneExample& source) {
    Result<Scene> scene = exampleScene(source.name + ".json");
    if (!scene)
        return fail(scene.error());
    return CaseScene{*std::move(scene), ImageSource{suite.folder}};
}

Result<CaseScene> openSource(const Suite& suite, const SceneInline& source) {
    Result<Scene> scene = parseScene(source.json);
    if (!scene)
        return fail(scene.error());
    return CaseScene{*std::move(scene), ImageSource{suite.folder}};
}

Result<lesson::LessonScene> sceneOfTask(const SceneLesson& source, const lesson::Step& step,
                                        lesson::LessonScene start) {
    const auto* predict = std::get_if<lesson::Predict>(&step.task);
    const auto* match = std::get_if<lesson::Match>(&step.task);
    if (source.reached && !match)
        return fail(ErrorCode::OutOfRange, "this step has no picture to reach", atPointer("/reached"));
    if (source.reached)
        return lesson::withEdits(start, match->edits);
    const std::size_t answers = predict ? predict->answers.size() : 0;
    if (source.answer > answers)
        return fail(ErrorCode::OutOfRange, Sentence("this step has {0} answers", answers),
                    atPointer("/answer"));
    return source.answer > 0 ? lesson::withEdits(start, predict->answers[source.answer - 1].edits)
                             : Result<lesson::LessonScene>(std::move(start));
}

Result<CaseScene> openSource(const Suite& suite, const SceneLesson& source) {
    std::error_code ignored;
    const Result<fs::path> path = pathInside(suite.folder, source.lesson);
    const bool isFolder = path && fs::is_directory(*path, ignored);
    const Result<lesson::LessonFolder> folder =
        isFolder ? lesson::LessonFolder::onDisk(*path) : lesson::LessonFolder::builtIn(source.lesson);
    if (!folder)
        return fail(folder.error());
    const Result<lesson::Lesson> lesson = readLesson(*folder);
    if (!lesson)
        return fail(lesson.error());
    if (source.step > lesson->steps.size())
        return fail(ErrorCode::OutOfRange, Sentence("the lesson has the steps 1 to {0}, and no {1}",
                                                    lesson->steps.size(), source.step));
    return startOf(*folder, *lesson, source.step - 1)
        .and_then([&](lesson::LessonScene start) {
            return sceneOfTask(source, lesson->steps[source.step - 1], std::move(start));
        })
        .map([](lesson::LessonScene scene) {
            return CaseScene{std::move(scene.scene), std::move(scene.images)};
        });
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

std::vector<std::string> goldensOf(const GoldenFiles::ForDriver& files, const Case& of,
                                   std::string_view driver) {
    std::vector<std::string> goldens;
    for (const std::string& pattern : files.patterns) {
        const std::string name =
            replaced(replaced(pattern, driverPlace, driver), "{picture}", of.pictureName);
        goldens.push_back(replaced(name, "{case}", of.goldenName));
    }
    return goldens;
}

/// Those of a lesson's scene are the lesson's.
Result<void> checkImages(const Suite& suite, const SceneSource& source, const CaseScene& opened) {
    if (std::holds_alternative<SceneLesson>(source))
        return {};
    for (const std::string& file : filesOf(opened.scene))
        if (const Result<void> stays = checkStays(suite.folder, opened.images.directory() / file); !stays)
            return stays;
    return {};
}

} // namespace

Result<void> CaseScene::load() {
    return images.load(scene);
}

Result<CaseScene> readScene(const Suite& suite, const SceneSource& source) {
    return std::visit([&](const auto& each) { return openSource(suite, each); }, source);
}

Result<CaseScene> openScene(const Plan& plan, const Case& of) {
    const Entry& entry = plan.entryOf(of);
    Result<CaseScene> opened = readScene(plan.suiteOf(of), entry.scenes[of.scene]);
    for (const std::vector<Edit>* edits : {&entry.edits, &of.edits}) {
        if (!opened)
            break;
        if (const Result<void> made = makeEdits(opened->scene, *edits); !made)
            return fail(made.error());
    }
    if (opened)
        if (const Result<void> stay = checkImages(plan.suiteOf(of), entry.scenes[of.scene], *opened); !stay)
            return fail(stay.error());
    return opened;
}

std::vector<std::string> goldensOf(const Plan& plan, const Case& of, std::string_view rendererString) {
    if (const auto* files = std::get_if<GoldenFiles>(&plan.settingsOf(of).golden))
        for (const GoldenFiles::ForDriver& each : files->drivers)
            if (fitsGlob(each.driver, rendererString))
                return goldensOf(each, of, driverSlug(rendererString));
    return {};
}

std::vector<std::string> goldensOfAnyDriver(const Plan& plan, const Case& of) {
    std::vector<std::string> goldens;
    if (const auto* files = std::get_if<GoldenFiles>(&plan.settingsOf(of).golden))
        for (const GoldenFiles::ForDriver& each : files->drivers)
            std::ranges::move(goldensOf(each, of, driverPlace), std::back_inserter(goldens));
    return goldens;
}

struct Fingerprints::Cache {
    /// By what tells one content from another without reading it, which is safe as long as a run lasts.
    std::map<FileFingerprint, std::string> hashes;

    std::string of(const fs::path& file) {
        const std::optional<FileFingerprint> fingerprint = texplorer::fingerprintOf(file);
        if (!fingerprint)
            return "absent";
        if (const auto found = hashes.find(*fingerprint); found != hashes.end())
            return found->second;
        const Result<Bytes> bytes = readFile(file);
        return hashes[*fingerprint] = bytes ? hashOf(*bytes) : bytes.error().message.english();
    }
};

Fingerprints::Fingerprints()
    : cache_(std::make_unique<Cache>()) {}

Fingerprints::~Fingerprints() = default;

std::string Fingerprints::of(const Plan& plan, const Case& each, std::string_view with,
                             std::string_view rendererString) {
    HashedText text;
    text.add(with);
    text.add(rendererString);
    const Settings& settings = plan.settingsOf(each);
    const fs::path& folder = plan.suiteOf(each).folder;
    const auto* reference = std::get_if<GoldenReference>(&settings.golden);
    const Criterion& criterion = settings.criterion;
    text.add(fmt::format("{} {}x{} {} {} {} {} {} {} {}", rowOf(each.renderer).name, each.size.width,
                         each.size.height, each.time, rowOf(criterion.metric).name, criterion.tolerance,
                         criterion.share, criterion.compared == Compared::Rgb ? "rgb" : "rgba",
                         criterion.pixelsPerDegree, reference ? reference->rule : ""));
    text.add(settings.mask.empty() ? "" : cache_->of(folder / settings.mask));
    for (const std::string& golden : goldensOf(plan, each, rendererString)) {
        text.add(golden);
        text.add(cache_->of(folder / golden));
    }
    const Result<CaseScene> opened = openScene(plan, each);
    if (!opened) {
        text.add(describe(opened.error()));
        return text.hash();
    }
    text.add(writeScene(opened->scene));
    for (const std::string& file : filesOf(opened->scene)) {
        text.add(file);
        text.add(cache_->of(opened->images.directory() / file));
    }
    return text.hash();
}

} // namespace texplorer::suite

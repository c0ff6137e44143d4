#include "app/ui/files/lessons.h"

#include "app/ui/files/replaced_document.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/state/lesson_records.h"
#include "texplorer/reference/false_colors.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer::ui {
namespace {

using lesson::Match;
using lesson::Predict;

const lesson::Step& stepOf(const LessonRun& run) {
    return run.lesson.steps[run.step];
}

StepRecord& recordOf(Session& session, const LessonRun& run) {
    return recordOf(session.settings, run.key, run.lesson.steps.size(), run.step);
}

/// "fixed", or "fixed,reference" for a comparison of two.
void showRenderers(ViewSettings& view, std::string_view names) {
    std::vector<RendererKind> wanted;
    for (std::size_t from = 0; from <= names.size();) {
        const std::size_t end = std::min(names.find(',', from), names.size());
        if (const EnumRow* row = findRow(EnumTable<RendererKind>::rows, names.substr(from, end - from)))
            wanted.push_back(static_cast<RendererKind>(row->value));
        from = end + 1;
    }
    if (wanted.size() > 1)
        showComparison(view, wanted);
    else if (!wanted.empty())
        showOne(view, wanted.front());
}

/// The scenes of all answers, or the target. An answer without edits, or with edits that fail, has none.
std::vector<LessonWork::Pictured> picturedScenes(const LessonRun& run) {
    const auto pictured = [&run](const std::vector<Edit>& edits) -> LessonWork::Pictured {
        Result<lesson::LessonScene> scene = withEdits(run.start, edits);
        return scene && !edits.empty() ? LessonWork::Pictured(*std::move(scene)) : std::nullopt;
    };
    const lesson::Step& step = stepOf(run);
    std::vector<LessonWork::Pictured> scenes;
    if (const auto* match = std::get_if<Match>(&step.task))
        scenes.push_back(pictured(match->edits));
    if (const auto* predict = std::get_if<Predict>(&step.task))
        std::ranges::transform(predict->answers, std::back_inserter(scenes),
                               [&](const lesson::Answer& answer) { return pictured(answer.edits); });
    return scenes;
}

/// Applies the step's look.
void look(Session& session, const lesson::Look& wanted) {
    const auto tab = std::ranges::find(tabRows, wanted.tab, &TabRow::name);
    if (tab != tabRows.end())
        session.window.wantedTab = tab->tab;
    const auto figure = std::ranges::find(figureRows, wanted.figure, &FigureRow::name);
    if (figure != figureRows.end()) {
        session.window.figure = figure->figure;
        session.window.wantedTab = Tab::Figures;
    }
    if (!wanted.param.empty())
        reveal(session, wanted.param);
    session.window.stepWants = true;
    const ShownPictures before = session.view;
    if (const EnumRow* shown = findRow(EnumTable<reference::Shown>::rows,
                                       wanted.shown.empty() ? std::string_view("picture") : wanted.shown))
        session.view.shown = static_cast<reference::Shown>(shown->value);
    if (wanted.probeX >= 0)
        session.look.wantedProbe =
            WantedProbe{[x = wanted.probeX, y = wanted.probeY](lesson::PictureSize picture, double /*zoom*/) {
                return lesson::pixelOf(x, y, picture);
            }};
    if (!wanted.renderer.empty())
        showRenderers(session.view, wanted.renderer);
    session.lesson->lookedAt = LessonPictures{before, session.view};
}

/// Images that the previous step has read are reused.
void shareImages(lesson::LessonScene& step, const Document& before) {
    if (!before.isLessons || before.images.directory() != step.images.directory())
        return;
    for (const std::string& file : filesOf(step.scene)) {
        if (!step.images.holds(file) && !before.images.fileInMemory(file))
            step.images.share(file, before.images, file);
    }
}

bool holdsAll(const ImageSource& images, const Scene& scene) {
    return std::ranges::all_of(filesOf(scene), [&](const std::string& file) { return images.holds(file); });
}

/// Replaces the document's scene and its history. Images may arrive later.
void showScene(Session& session, const lesson::LessonScene& scene) {
    Document document(scene.scene, scene.images);
    document.isLessons = true;
    document.used.clear();     // missing images are read
    document.needsFit = false; // pictures are compared and pixels named with the step's own camera
    replaceDocument(session, std::move(document));
}

/// Finds which of the lesson's keys have an effect in its step.
void readyKeys(LessonRun& run) {
    const std::vector<lesson::LessonKey>& keys = run.lesson.keys;
    run.usable.clear();
    for (const lesson::LessonKey& key : keys)
        run.usable.push_back(checkKey(run.start.scene, key).has_value());
    run.chosen.clear();
    run.keyed.reset();
    run.pressed.reset();
}

/// Finds the current choices of the keys, which undo and panels can change as well.
void followKeys(const Session& session, LessonRun& run) {
    const Scene& scene = presentScene(session);
    if (run.lesson.keys.empty() || run.keyed == scene)
        return;
    run.chosen = run.pressed && run.pressed->scene == scene ? run.pressed->chosen
                                                            : choicesOf(scene, run.lesson.keys, run.chosen);
    run.keyed = scene;
}

/// Its images may be missing: they are read with the document.
Result<lesson::LessonScene> startOfStep(const Session& session, const lesson::LessonFolder& folder,
                                        const lesson::Lesson& lesson, std::size_t step) {
    return startOf(folder, lesson, step, lesson::StepImages::Leave, session.window.textureUnits);
}

void askPictures(Session& session, const LessonRun& run) {
    LessonWork& work = session.services.lessons;
    work.pictures.rest();
    if (std::vector<LessonWork::Pictured> scenes = picturedScenes(run); !scenes.empty())
        work.pictures.ask(std::move(scenes));
}

/// Gives the step's scene the vertices of its files, and makes the scene to reach.
void readyStart(LessonRun& run) {
    run.start.images.fillMeshes(run.start.scene);
    if (const auto* match = std::get_if<Match>(&stepOf(run).task)) {
        if (const Result<lesson::LessonScene> target = withEdits(run.start, match->edits))
            run.target = target->scene;
    }
}

void begin(Session& session) {
    LessonRun& run = *session.lesson;
    readyKeys(run);
    static_cast<LessonStepRun&>(run) = {.wantedScroll = LessonRun::Scroll::Top};
    session.services.lessons->rest();
    shareImages(run.start, session.document);
    readyStart(run);
    run.awaitsImages = !holdsAll(run.start.images, run.start.scene);
    showScene(session, run.start);
    if (!run.awaitsImages)
        askPictures(session, run);
    look(session, stepOf(run).look);
    const lesson::Step& step = stepOf(run);
    const bool asks = std::holds_alternative<Predict>(step.task) || std::holds_alternative<Match>(step.task);
    if (!asks)
        recordOf(session, run).done = true; // a step without a task is done when it was read
}

/// The texts, the scenes and the catalogue of a folder, including missing files, which may be created later.
/// Images are watched with the document.
std::vector<std::filesystem::path> filesOfLesson(const lesson::LessonFolder& folder,
                                                 const lesson::Lesson& lesson, Language language) {
    if (folder.path().empty())
        return {};
    std::vector<std::filesystem::path> files{folder.path() / lesson::lessonFileName};
    if (language != Language::English)
        files.push_back(folder.path() / catalogueFileOf(language));
    for (const lesson::Step& step : lesson.steps) {
        if (!step.scene.empty() && !std::filesystem::path(step.scene).has_parent_path())
            files.push_back(folder.path() / step.scene);
    }
    return files;
}

void translateTexts(LessonRun& run) {
    const Catalogue* window = catalogueInUse();
    const Language wanted = window ? window->language() : Language::English;
    if (run.language == wanted)
        return;
    run.language = wanted;
    run.catalogue = catalogueOfLesson(run.folder, wanted);
    run.files = filesOfLesson(run.folder, run.lesson, wanted);
}

void tellProblem(Session& session, const Error& error) {
    LessonRun& run = *session.lesson;
    say(session,
        {error.code,
         Sentence("the lesson has changed and can't be read, so the old one stays: {0}", describe(error)),
         {}},
        error.where.isOf(Location::Kind::File) ? error.where.steps().front().text : std::string());
    run.problem = session.look.notice.text;
}

/// The camera of `camera` with the other settings of `view`.
View seenFrom(View camera, const View& view) {
    camera.background = view.background;
    camera.perspectiveHint = view.perspectiveHint;
    return camera;
}

/// The scene that is compared: if the step is not about the camera, any camera is allowed.
Scene comparedScene(const LessonRun& run, const Scene& target, Scene scene) {
    const View& start = run.start.scene.view;
    if (target.view == seenFrom(start, target.view))
        scene.view = seenFrom(start, scene.view);
    return scene;
}

/// Takes in images that were missing when the step's scene was shown, or their errors.
void receiveImages(Session& session, LessonRun& run) {
    const Document& document = session.document;
    if (!run.awaitsImages || !document.loads.empty() || document.used.empty())
        return; // or not requested yet
    run.awaitsImages = false;
    for (const std::string& file : filesOf(run.start.scene))
        run.start.images.share(file, document.images, file);
    readyStart(run);
    askPictures(session, run);
}

/// Updates the numbers of the step's scene in the shown picture.
void followNumbers(Session& session, LessonRun& run, lesson::PictureSize picture) {
    LessonWork& work = session.services.lessons;
    if (std::optional<lesson::StepNumbers> numbers = work.numbers.take()) {
        if (run.answer && !run.numbers)
            run.wantedScroll = LessonRun::Scroll::Verdict;
        run.numbers = std::move(numbers);
    }
    if (picture.width < 1 || picture.height < 1)
        picture = lesson::pageSize; // a panel covers it
    if (run.awaitsImages || run.numbersFor == picture)
        return;
    run.numbersFor = picture;
    work.numbers.rest();
    work.numbers.ask({run.start, stepOf(run), picture});
}

void followMatch(Session& session, LessonRun& run) {
    LessonWork& work = session.services.lessons;
    Scene compared = comparedScene(run, *run.target, session.document.scene);
    if (std::optional<LessonWork::Graded> graded = work.grades.take()) {
        const bool isOfAnEdit =
            run.grade || graded->scene != comparedScene(run, *run.target, run.start.scene);
        if (isOfAnEdit && !(run.grade && percentWrong(*run.grade) == percentWrong(graded->grade)))
            run.wantedScroll = LessonRun::Scroll::Verdict;
        run.grade = std::move(graded->grade);
        if (run.grade->passed && graded->scene == compared)
            recordOf(session, run).done = true;
    }
    if (std::optional<LessonWork::Hinted> hint = work.hints.take())
        run.hint = std::move(hint);
    if (run.wantsHint && run.grade && !run.grade->passed && run.hintAsked != compared) {
        run.hintAsked = compared;
        work.hints.ask({compared, *run.target, session.document.images});
    }
    if (run.asked == compared)
        return;
    run.asked = std::move(compared);
    work.grades.ask({*run.asked, *run.target, session.document.images});
}

} // namespace

Result<void> openLesson(Session& session, const lesson::LessonFolder& folder,
                        std::optional<std::size_t> step) {
    Result<lesson::Lesson> lesson = readLesson(folder);
    if (!lesson)
        return fail(lesson.error());
    const std::string key = progressKey(folder);
    takeOldRecords(session.settings, folder, key);
    const auto records = session.settings.lessons.find(key);
    if (!step && records != session.settings.lessons.end()) {
        const auto open = std::ranges::find(records->second, false, &StepRecord::done);
        step = static_cast<std::size_t>(open - records->second.begin());
    }
    const std::size_t last = lesson->steps.size() - 1;
    const std::size_t first = step.value_or(0) > last ? 0 : step.value_or(0);
    Result<lesson::LessonScene> start = startOfStep(session, folder, *lesson, first);
    if (!start)
        return fail(start.error());
    endLessonPictures(session);
    session.lesson.emplace(folder, *std::move(lesson), first, *std::move(start));
    session.lesson->files = filesOfLesson(folder, session.lesson->lesson, Language::English);
    translateTexts(*session.lesson);
    showTab(session.settings.workspace, Tab::Lesson);
    begin(session);
    return {};
}

Result<void> openLessonNamed(Session& session, const std::string& nameOrFolder,
                             std::optional<std::size_t> step) {
    std::error_code ignored;
    if (std::filesystem::is_directory(nameOrFolder, ignored))
        return openLesson(session, lesson::LessonFolder::onDisk(nameOrFolder), step);
    return lesson::LessonFolder::builtIn(nameOrFolder).and_then([&](const lesson::LessonFolder& folder) {
        return openLesson(session, folder, step);
    });
}

void goToLessonStep(Session& session, std::size_t step) {
    std::optional<LessonRun>& run = session.lesson;
    if (!run || step >= run->lesson.steps.size())
        return;
    Result<lesson::LessonScene> start = startOfStep(session, run->folder, run->lesson, step);
    if (!start)
        return say(session, start.error());
    run->step = step;
    run->start = *std::move(start);
    begin(session);
}

void answerQuestion(Session& session, std::size_t answer) {
    if (!session.lesson)
        return;
    LessonRun& run = *session.lesson;
    const auto* predict = std::get_if<Predict>(&stepOf(run).task);
    if (!predict || answer >= predict->answers.size())
        return;
    run.answer = answer;
    run.wantedScroll = LessonRun::Scroll::Verdict;
    StepRecord& record = recordOf(session, run);
    const bool right = answer == predict->right;
    if (!record.done) {
        record.tries = std::min(record.tries + 1, maxTriesKept);
        record.answer = static_cast<int>(answer);
    }
    if (!right)
        return;
    record.done = true;
    if (predict->answers[answer].edits.empty())
        return;
    const lesson::LessonScene scene =
        withEdits(run.start, predict->answers[answer].edits).value_or(run.start);
    submit(session,
           {.name = N_("Answer"), .edits = {edit::Replace{std::make_shared<const Scene>(scene.scene)}}});
}

void followLesson(Session& session, const LessonPlace& place) {
    std::optional<LessonRun>& run = session.lesson;
    const bool hasFewer = std::exchange(session.window.textureUnits, place.units) > place.units;
    if (!run)
        return;
    if (hasFewer && lesson::unitsUsed(run->start.scene) > place.units)
        goToLessonStep(session, run->step);
    translateTexts(*run);
    if (run->hasChanged && session.asking.dialog == Dialog::None)
        reloadLesson(session);
    followKeys(session, *run);
    LessonWork& work = session.services.lessons;
    if (auto pictures = work.pictures.take())
        run->pictures = *std::move(pictures);
    receiveImages(session, *run);
    followNumbers(session, *run, place.picture);
    if (run->target && !run->awaitsImages)
        followMatch(session, *run);
}

void reloadLesson(Session& session) {
    LessonRun& run = *session.lesson;
    run.hasChanged = false;
    Result<lesson::Lesson> lesson = readLesson(run.folder);
    if (!lesson)
        return tellProblem(session, lesson.error());
    run.files = filesOfLesson(run.folder, *lesson, run.language);
    const std::size_t step = std::min(run.step, lesson->steps.size() - 1);
    Result<lesson::LessonScene> start = startOfStep(session, run.folder, *lesson, step);
    const std::string file = (run.folder.path() / lesson::lessonFileName).string();
    if (!start)
        return tellProblem(session, within(inFile(file), start.error()));
    Result<std::shared_ptr<const Catalogue>> catalogue = readLessonCatalogue(run.folder, run.language);
    if (!catalogue)
        return tellProblem(session, catalogue.error());
    if (!run.problem.empty() && session.look.notice.text == run.problem)
        session.look.notice = {};
    run.problem.clear();
    run.catalogue = *std::move(catalogue);
    const lesson::Step& shown = stepOf(run);
    const bool goesOn = step == run.step && start->scene == run.start.scene &&
                        lesson->steps[step].look == shown.look && lesson->steps[step].task == shown.task;
    run.lesson = *std::move(lesson);
    run.step = step;
    if (goesOn) {
        for (const std::string& image : filesOf(start->scene))
            start->images.share(image, session.document.images, image);
    }
    run.start = *std::move(start);
    if (!goesOn)
        begin(session);
    else
        readyKeys(run);
}

} // namespace texplorer::ui

#include "app/screenshot/shots/shot_run.h"

#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/picture_writer.h"
#include "app/screenshot/shots/picture_texts.h"
#include "app/screenshot/shots/shot_drawer.h"
#include "core/base/count.h"
#include "core/base/parallel.h"
#include "core/base/tried.h"
#include "core/diagnosis/diagnosis.h"
#include "core/image/convert.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr unsigned mostEncoders = 4;
constexpr unsigned mostContexts = 4;         // which share the driver's own threads, where it has some
constexpr std::size_t picturesOfContext = 8; // that make up for what a context costs

bool isCompressed(const Scene& scene) {
    return std::ranges::find(scene.textures, Compression::Cached, &Texture::compression) !=
           scene.textures.end();
}

/// What one sees: a viewer would let its own background through the framebuffer's alpha. False colours are no
/// framebuffer: where there is none, there is nothing.
bool isOpaque(const ShotRequest& request) {
    return request.window || request.shown == reference::Shown::Picture;
}

/// What there is to say of a picture that was drawn.
std::vector<Error> warningsAbout(const ShotRequest& request, const Shot& shot) {
    std::vector<Error> errors;
    for (const std::string& problem : shot.frame.problems)
        errors.push_back({ErrorCode::Driver, problem, {}});
    for (const Finding& each : diagnose(request.scene, request.images, shot.driver.facts)) {
        if (each.severity <= Severity::Warning && !each.reportedByRenderer) // else it is a problem already
            errors.push_back({ErrorCode::Malformed, each.sentence, each.path});
    }
    return errors;
}

/// The same sentence, of one of several pictures.
Error ofPicture(const Error& error, const std::string& name) {
    return {error.code, describe(error), name};
}

/// The scene of each case, with its images: those of the last scene are kept for the next.
class Scenes {
public:
    explicit Scenes(const ShotList& list)
        : list_(list) {}

    Result<void> put(const ShotList::Case& shot, ShotRequest& request) {
        const ShotList::Entry& entry = list_.entryOf(shot);
        Result<Scene> scene = list_.sceneOf(shot);
        if (!scene)
            return fail(scene.error());
        if (entry_ != shot.entry) {
            ImageSource images = entry.opened.images;
            for (const std::string& file : filesOf(*scene)) {
                if (images.directory() == images_.directory() && !images.holds(file))
                    images.share(file, images_, file);
            }
            images_ = std::move(images);
            entry_ = shot.entry;
        }
        if (const Result<void> loaded = images_.load(*scene); !loaded)
            return entry.file.empty() ? fail(loaded.error())
                                      : fail(loaded.error().code, describe(loaded.error()), entry.file);
        request.scene = *std::move(scene);
        request.images = images_;
        request.file = entry.file;
        request.time = shot.time;
        request.size = shot.size;
        return {};
    }

private:
    const ShotList& list_;
    std::optional<std::size_t> entry_;
    ImageSource images_;
};

/// Sentences about pictures, in the pictures' order whoever has drawn them. Why there is none is said at
/// once, a warning at the end: once, however many pictures it is about.
class Sentences {
public:
    explicit Sentences(LongWork& work)
        : work_(work) {}

    /// `failure`: why there is no picture.
    void put(std::size_t index, std::vector<Error> warnings, std::optional<Error> failure) {
        const std::scoped_lock lock(mutex_);
        waiting_.emplace(index, About{std::move(warnings), std::move(failure)});
        for (auto next = waiting_.begin(); next != waiting_.end() && next->first == said_;
             next = waiting_.erase(next), ++said_) {
            auto& [said, failed] = next->second;
            for (Error& warning : said)
                add(std::move(warning));
            if (failed) {
                work_.clearLine();
                complain(*failed);
            }
        }
    }

    /// When no more pictures come.
    void sayWarnings() {
        const std::scoped_lock lock(mutex_);
        for (auto& [first, pictures] : warnings_) {
            if (pictures > 1)
                first.message += fmt::format(" (and of {})", countOf(pictures - 1, "more picture"));
            warn(first);
        }
        warnings_.clear();
    }

private:
    struct About {
        std::vector<Error> warnings;
        std::optional<Error> failure;
    };

    struct Warning {
        Error first; ///< of the first picture
        std::size_t pictures = 1;
    };

    void add(Error warning) {
        const auto [at, isNew] = numbers_.try_emplace(warning.message, warnings_.size());
        if (isNew)
            warnings_.push_back({std::move(warning)});
        else
            ++warnings_[at->second].pictures;
    }

    LongWork& work_;
    std::mutex mutex_;
    std::vector<Warning> warnings_;                        ///< in the order of their first pictures
    std::unordered_map<std::string, std::size_t> numbers_; ///< of each among them, by its sentence
    std::map<std::size_t, About> waiting_;                 ///< for those before them
    std::size_t said_ = 0;                                 ///< of how many pictures, from the first
};

/// What the threads that draw have in common.
struct Drawing {
    const ShotRun& run;
    LongWork& work;
    PictureWriter writer;
    Sentences sentences;
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> incomplete = false;
    std::mutex mutex{};
    std::optional<Error> unopened{}; ///< why there is no context: nothing can be drawn

    [[nodiscard]] bool goesOn() const { return !work.stopToken().stop_requested() && !writer.failure(); }
};

void drawCase(Drawing& all, std::size_t index, Scenes& scenes, ShotDrawer& drawer, ShotRequest& request) {
    const std::string& name = all.run.names[index];
    std::vector<Error> warnings;
    std::optional<Error> failed;
    Result<Shot> shot = tried({"there is no memory to draw it", "it can't be drawn"}, [&]() -> Result<Shot> {
        if (const Result<void> there = scenes.put(all.run.list.at(index), request); !there)
            return fail(there.error());
        Result<Shot> drawn = drawer.draw(request);
        if (drawn)
            warnings = warningsAbout(request, *drawn);
        return drawn;
    });
    if (!shot && shot.error().code == ErrorCode::Cancelled)
        return;
    if (!shot) {
        failed = ofPicture(shot.error(), name);
        all.incomplete = true;
    }
    if (all.run.report != nullptr) {
        const ShotList::Case picture = all.run.list.at(index);
        const ShotList::Entry& entry = all.run.list.entryOf(picture);
        if (shot)
            all.run.report->add(index, name, entry, picture, request, *shot, warnings);
        else
            all.run.report->add(index, name, entry, picture, shot.error());
    }
    for (Error& each : warnings)
        each = ofPicture(each, name);
    all.sentences.put(index, std::move(warnings), std::move(failed));
    if (shot) {
        std::optional<PictureFacts> facts;
        if (all.run.withTexts)
            facts = factsOf(request, *shot);
        all.writer.write(
            {std::move(shot->frame.image), isOpaque(request), name, all.run.format, std::move(facts)});
    }
    all.work.report(static_cast<float>(++all.done) / static_cast<float>(all.run.names.size()));
}

/// On one thread, with a context of its own: the next picture, as long as there is one.
void drawThem(Drawing& all) {
    ShotRequest request = all.run.common;
    request.levels.stop = all.work.stopToken();
    ShotDrawer drawer;
    if (const Result<void> open = drawer.open(request); !open) {
        const std::scoped_lock lock(all.mutex);
        all.unopened = open.error();
        return;
    }
    Scenes scenes(all.run.list);
    while (all.goesOn()) {
        const std::size_t index = all.next++;
        if (index >= all.run.names.size())
            return;
        drawCase(all, index, scenes, drawer, request);
    }
}

/// Contexts side by side: half of a picture's time is the driver's on the thread that draws, which compiles
/// for each state. A window and the reference have the processors to themselves.
unsigned contextsFor(const ShotRun& run) {
    if (run.common.window || run.common.renderer == RendererKind::Reference)
        return 1;
    const std::size_t worthwhile = std::max<std::size_t>(1, run.names.size() / picturesOfContext);
    return static_cast<unsigned>(
        std::min<std::size_t>(worthwhile, std::min(processorThreads(), mostContexts)));
}

} // namespace

ExitCode drawOne(ShotRequest request, const SceneArgument& scene, const ImageOutput& output, bool withTexts,
                 ShotReport* report) {
    if (const auto loaded = request.images.load(request.scene); !loaded)
        return complain(inScene(scene, loaded.error()));
    tellOfImages(request.images);
    std::optional<LongWork> compressing; // else Ctrl+C ends the program at once
    if (isCompressed(request.scene)) {
        compressing.emplace("texshot: compressing");
        request.levels.progress = [&work = *compressing](float done) { work.report(done); };
        request.levels.stop = compressing->stopToken();
    }
    ShotDrawer drawer;
    Result<Shot> shot = drawer.draw(request);
    if (compressing)
        compressing->finish();
    if (request.levels.stop.stop_requested())
        return complainInterrupted();
    if (!shot)
        return complain(shot.error());
    if (!shot->driver.name.empty())
        tell("drawn by " + shot->driver.name);
    const std::vector<Error> warnings = warningsAbout(request, *shot);
    for (const Error& warning : warnings)
        warn(warning);
    if (report != nullptr)
        report->add(0, output.path, {sceneName(scene.path().string()), scene.file, {}},
                    {0, request.size, request.time}, request, *shot, warnings);
    WriteOptions options;
    if (withTexts)
        options.texts = textsOf(factsOf(request, *shot));
    Image& image = shot->frame.image;
    const TextureImage seen =
        textureOf(isOpaque(request) ? withoutAlpha(std::move(image)) : std::move(image), {});
    if (const auto written = output.write(seen, options); !written)
        return complain(written.error());
    if (report != nullptr)
        report->finish();
    return success;
}

ExitCode drawAll(const ShotRun& run) {
    LongWork work("texshot: drawing");
    Drawing all{run, work, PictureWriter(std::min(processorThreads(), mostEncoders)), Sentences(work)};
    all.incomplete = run.incomplete;
    const unsigned contexts = contextsFor(run);
    parallelFor(contexts, contexts, [&](std::size_t) { drawThem(all); });
    all.writer.finish();
    work.finish();
    all.sentences.sayWarnings();
    const std::size_t count = run.names.size();
    const std::string written =
        fmt::format("{} of {} were written", all.writer.written(), countOf(count, "picture"));
    if (const std::optional<Error> lost = all.writer.failure())
        return complain({lost->code, fmt::format("{}; {}", lost->message, written), lost->where});
    if (work.stopToken().stop_requested())
        return complainInterrupted(all.writer.written() > 0 ? written : std::string());
    if (all.unopened && all.next < count) // another thread's context has done without it
        return complain(*all.unopened);
    if (run.report != nullptr)
        run.report->finish();
    return all.incomplete ? failure : success;
}

} // namespace texplorer::screenshot

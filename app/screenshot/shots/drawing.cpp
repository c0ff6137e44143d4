#include "app/screenshot/shots/drawing.h"

#include "app/screenshot/output/answer.h"
#include "app/screenshot/shots/shot_drawer.h"
#include "texplorer/base/parallel.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/tried.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/params/scene_at.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr unsigned maxContexts = 4;          // which share the driver's own threads, where it has some
constexpr std::size_t picturesOfContext = 8; // that make up for what a context costs

/// The same sentence, of one of several pictures.
Error ofPicture(const Error& error, const std::string& name) {
    return within(inFile(name), error);
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
                                      : fail(within(inFile(entry.file), loaded.error()));
        request.scene = *std::move(scene);
        request.images = images_;
        request.file = entry.file;
        request.renderer = shot.renderer;
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
    [[nodiscard]] std::vector<Error> takeWarnings() {
        const std::scoped_lock lock(mutex_);
        std::vector<Error> taken;
        for (auto& [first, pictures] : std::exchange(warnings_, {})) {
            if (pictures > 1)
                first.message =
                    Sentence("{0} (and of {1})", first.message,
                             Sentence::plural("{0} more picture", "{0} more pictures", pictures - 1));
            taken.push_back(std::move(first));
        }
        return taken;
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
        const Error inPicture{warning.code, warning.message, warning.where.inside()};
        const auto [at, isNew] = numbers_.try_emplace(describe(inPicture), warnings_.size());
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

bool drawsByOpenGl(RendererKind renderer) {
    return renderer != RendererKind::Reference;
}

/// What the threads that draw have in common.
struct Threads {
    const Drawing& drawing;
    Sentences sentences;
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> incomplete = false;
    std::mutex mutex{};
    std::optional<Error> unopened{}; ///< why there is no context: nothing can be drawn

    [[nodiscard]] bool goOn() const {
        return !drawing.work.stopToken().stop_requested() && (!drawing.goesOn || drawing.goesOn());
    }
};

void drawCase(Threads& all, std::size_t index, Scenes& scenes, ShotDrawer& drawer, ShotRequest& request) {
    const std::string& name = all.drawing.names[index];
    std::vector<Error> warnings;
    std::optional<Error> failed;
    Result<Shot> shot = tried({"not enough memory to draw it", "it can't be drawn"}, [&]() -> Result<Shot> {
        if (const Result<void> there = scenes.put(all.drawing.list.at(index), request); !there)
            return fail(there.error());
        Result<Shot> drawn = drawer.draw(request);
        if (drawn)
            warnings = warningsAbout(request, *drawn);
        return drawn;
    });
    if (all.drawing.work.stopToken().stop_requested())
        return; // textures may be missing in it
    if (!shot) {
        failed = ofPicture(shot.error(), name);
        all.incomplete = true;
    }
    all.drawing.take({index, request, shot, warnings});
    for (Error& each : warnings)
        each = ofPicture(each, name);
    all.sentences.put(index, std::move(warnings), std::move(failed));
    all.drawing.work.report(static_cast<float>(++all.done) / static_cast<float>(all.drawing.names.size()));
}

/// On one thread, with a context of its own: the next picture, as long as there is one.
void drawThem(Threads& all) {
    ShotRequest request = all.drawing.common;
    const std::vector<RendererKind>& renderers = all.drawing.list.renderers();
    if (const auto byOpenGl = std::ranges::find_if(renderers, drawsByOpenGl); byOpenGl != renderers.end())
        request.renderer = *byOpenGl; // for which the context is opened
    request.levels.stop = all.drawing.work.stopToken();
    ShotDrawer drawer;
    if (const Result<void> open = drawer.open(request); !open) {
        const std::scoped_lock lock(all.mutex);
        all.unopened = open.error();
        return;
    }
    Scenes scenes(all.drawing.list);
    while (all.goOn()) {
        const std::size_t index = all.next++;
        if (index >= all.drawing.names.size())
            return;
        drawCase(all, index, scenes, drawer, request);
    }
}

/// Contexts side by side: half of a picture's time is the driver's on the thread that draws, which compiles
/// for each state. A window and the reference have the processors to themselves.
unsigned contextsFor(const Drawing& drawing) {
    if (drawing.common.window || std::ranges::none_of(drawing.list.renderers(), drawsByOpenGl))
        return 1;
    const std::size_t worthwhile = std::max<std::size_t>(1, drawing.names.size() / picturesOfContext);
    return static_cast<unsigned>(
        std::min<std::size_t>(worthwhile, std::min(processorThreads(), maxContexts)));
}

} // namespace

std::vector<Error> warningsAbout(const ShotRequest& request, const Shot& shot) {
    std::vector<Error> errors;
    for (const std::string& problem : shot.frame.problems)
        errors.push_back({ErrorCode::Driver, problem, {}});
    const StandingScene standing(request.scene, request.time);
    for (const Finding& each : diagnose(*standing, request.limitedImages(), shot.driver.facts)) {
        if (each.severity <= Severity::Warning && !each.reportedByRenderer) // else it is a problem already
            errors.push_back({ErrorCode::Malformed, each.sentence, each.path});
    }
    return errors;
}

bool isOpaque(const ShotRequest& request) {
    return request.window || request.shown == reference::Shown::Picture;
}

DrawingEnd drawList(const Drawing& drawing) {
    Threads all{drawing, Sentences(drawing.work)};
    const unsigned contexts = contextsFor(drawing);
    parallelFor(contexts, contexts, [&](std::size_t) { drawThem(all); });
    DrawingEnd end{.complete = !all.incomplete, .warnings = all.sentences.takeWarnings()};
    if (all.next < drawing.names.size()) // else another thread's context has done without it
        end.unopened = all.unopened;
    return end;
}

} // namespace texplorer::screenshot

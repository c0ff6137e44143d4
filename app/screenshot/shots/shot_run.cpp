#include "app/screenshot/shots/shot_run.h"

#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/picture_writer.h"
#include "app/screenshot/shots/picture_texts.h"
#include "app/screenshot/shots/shot_drawer.h"
#include "core/base/count.h"
#include "core/base/parallel.h"
#include "core/diagnosis/diagnosis.h"
#include "core/image/convert.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr unsigned mostEncoders = 4; // they keep up with one thread that draws

bool isCompressed(const Scene& scene) {
    return std::ranges::find(scene.textures, Compression::Cached, &Texture::compression) !=
           scene.textures.end();
}

/// What one sees: a viewer would let its own background through the framebuffer's alpha. False colours are no
/// framebuffer: where there is none, there is nothing.
bool isOpaque(const ShotRequest& request) {
    return request.window || request.shown == reference::Shown::Picture;
}

/// What there is to say of a picture that was drawn. `name`: the picture's, where there are several.
void complainAbout(const ShotRequest& request, const Shot& shot, const std::string& name = {}) {
    for (const std::string& problem : shot.frame.problems)
        complain({ErrorCode::Driver, problem, name});
    for (const Finding& each : diagnose(request.scene, request.images, shot.driver.facts)) {
        if (each.severity > Severity::Warning || each.reportedByRenderer) // else it is a problem already
            continue;
        const Error finding{ErrorCode::Malformed, each.sentence, each.path};
        complain(name.empty() ? finding : Error{finding.code, describe(finding), name});
    }
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

Result<Shot> drawCase(const ShotRun& run, std::size_t index, Scenes& scenes, ShotDrawer& drawer,
                      ShotRequest& request) {
    if (const Result<void> there = scenes.put(run.list.at(index), request); !there)
        return fail(there.error());
    return drawer.draw(request);
}

} // namespace

ExitCode drawOne(ShotRequest request, const SceneArgument& scene, const ImageOutput& output, bool withTexts) {
    if (const auto loaded = request.images.load(request.scene); !loaded)
        return complain(inScene(scene, loaded.error()));
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
    complainAbout(request, *shot);
    WriteOptions options;
    if (withTexts)
        options.texts = textsOf(factsOf(request, *shot));
    Image& image = shot->frame.image;
    const TextureImage seen =
        textureOf(isOpaque(request) ? withoutAlpha(std::move(image)) : std::move(image), {});
    const auto written = output.write(seen, options);
    return written ? success : complain(written.error());
}

ExitCode drawAll(const ShotRun& run) {
    ShotRequest request = run.common;
    LongWork work("texshot: drawing");
    request.levels.stop = work.stopToken();
    ShotDrawer drawer;
    if (const Result<void> open = drawer.open(request); !open)
        return complain(open.error());
    Scenes scenes(run.list);
    PictureWriter writer(std::min(processorThreads(), mostEncoders));
    bool failed = run.incomplete;
    const std::size_t count = run.names.size();
    for (std::size_t i = 0; i < count && !work.stopToken().stop_requested() && !writer.failure(); ++i) {
        Result<Shot> shot = drawCase(run, i, scenes, drawer, request);
        if (work.stopToken().stop_requested())
            break;
        work.clearLine();
        if (!shot) {
            complain({shot.error().code, describe(shot.error()), run.names[i]});
            failed = true;
            continue;
        }
        complainAbout(request, *shot, run.names[i]);
        std::optional<PictureFacts> facts;
        if (run.withTexts)
            facts = factsOf(request, *shot);
        writer.write(
            {std::move(shot->frame.image), isOpaque(request), run.names[i], run.format, std::move(facts)});
        work.report(static_cast<float>(i + 1) / static_cast<float>(count));
    }
    writer.finish();
    work.finish();
    const std::string written =
        fmt::format("{} of {} were written", writer.written(), countOf(count, "picture"));
    if (const std::optional<Error> failure = writer.failure())
        return complain({failure->code, fmt::format("{}; {}", failure->message, written), failure->where});
    if (work.stopToken().stop_requested())
        return complainInterrupted(writer.written() > 0 ? written : std::string());
    return failed ? failure : success;
}

} // namespace texplorer::screenshot

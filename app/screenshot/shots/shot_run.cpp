#include "app/screenshot/shots/shot_run.h"

#include "app/screenshot/gl/picture_texts.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/picture_writer.h"
#include "app/screenshot/shots/drawing.h"
#include "app/screenshot/shots/shot_drawer.h"
#include "texplorer/base/parallel.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/image/convert.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr unsigned maxEncoders = 4;

bool isCompressed(const Scene& scene) {
    return std::ranges::find(scene.textures, Compression::Cached, &Texture::compression) !=
           scene.textures.end();
}

/// Tells the report of a picture and gives it to the writer.
void takeShot(const ShotRun& run, PictureWriter& writer, const DrawnShot& drawn) {
    const std::string& name = run.names[drawn.index];
    if (run.report != nullptr) {
        const ShotList::Case picture = run.list.at(drawn.index);
        const ShotList::Entry& entry = run.list.entryOf(picture);
        if (drawn.shot)
            run.report->add(drawn.index, name, entry, picture, drawn.request, *drawn.shot, drawn.warnings);
        else
            run.report->add(drawn.index, name, entry, picture, drawn.shot.error());
    }
    if (!drawn.shot)
        return;
    std::optional<PictureFacts> facts;
    if (run.withTexts)
        facts = factsOf(drawn.request, *drawn.shot);
    writer.write(
        {std::move(drawn.shot->frame.image), isOpaque(drawn.request), name, run.format, std::move(facts)});
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
        return complain(shot.error(), statusOf(shot.error()));
    if (!shot->driver.name.empty())
        tell("drawn by " + shot->driver.name);
    const std::vector<Error> warnings = warningsAbout(request, *shot);
    for (const Error& warning : warnings)
        warn(warning);
    if (report != nullptr)
        report->add(0, output.path, {sceneName(scene.path().string()), scene.file, {}},
                    {0, request.renderer, request.size, request.time}, request, *shot, warnings);
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
    PictureWriter writer(std::min(processorThreads(), maxEncoders));
    const DrawingEnd end = drawList({.list = run.list,
                                     .names = run.names,
                                     .common = run.common,
                                     .work = work,
                                     .take = [&](const DrawnShot& drawn) { takeShot(run, writer, drawn); },
                                     .goesOn = [&] { return !writer.failure(); }});
    writer.finish();
    work.finish();
    for (const Error& each : end.warnings)
        warn(each);
    const Sentence written("{0} of {1} were written", writer.written(),
                           Sentence::plural("{0} picture", "{0} pictures", run.names.size()));
    if (const std::optional<Error> lost = writer.failure())
        return complain({lost->code, Sentence("{0}; {1}", lost->message, written), lost->where});
    if (work.stopToken().stop_requested())
        return complainInterrupted(writer.written() > 0 ? written : Sentence());
    if (end.unopened)
        return complain(*end.unopened);
    if (run.report != nullptr)
        run.report->finish();
    return end.complete && !run.incomplete ? success : failure;
}

} // namespace texplorer::screenshot

#include "app/ui/files/recording_file.h"

#include "app/animation/make_encoder.h"
#include "app/ui/model/session.h"
#include "app/view/picture_texts.h"
#include "texplorer/animation/frame_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxPictures = 10'000; // as in texshot animate

animation::Settings settingsOf(const Recording& recording) {
    animation::Settings settings{.width = recording.picture.width, .height = recording.picture.height};
    settings.unitsPerSecond = animation::rowOf(recording.format).unitsPerSecond;
    view::PictureFacts facts{recording.picture.scene,
                             recording.picture.time,
                             {recording.picture.width, recording.picture.height},
                             std::string(texplorer::rowOf(RendererKind::Reference).name)};
    facts.program = "texplorer";
    settings.texts = view::textsOf(facts);
    return settings;
}

Result<MadeFile> madeOf(const Recording& recording, const FileMaking& making) {
    auto encoder = animation::makeEncoder(recording.format, settingsOf(recording));
    if (!encoder)
        return fail(encoder.error());
    const std::size_t all = recording.pictures();
    const std::vector<int> durations = animation::durationsOf(
        all, recording.perSecond, recording.seconds, animation::rowOf(recording.format).unitsPerSecond);
    reference::ReferenceRenderer renderer;
    reference::DrawRequest request = recording.picture;
    for (std::size_t i = 0; i < all; ++i) {
        making.report(static_cast<float>(i) / static_cast<float>(all));
        request.time = recording.picture.time + static_cast<double>(i) / recording.perSecond;
        const Result<Frame> frame = renderer.draw(
            request, {.threads = making.threads, .levels = making.levels, .stop = making.levels.stop});
        const Result<void> added = frame ? (*encoder)->add(frame->image, durations[i]) : fail(frame.error());
        if (!added)
            return fail(added.error());
    }
    return (*encoder)->finish().map([](Bytes bytes) { return MadeFile{std::move(bytes)}; });
}

} // namespace

std::size_t Recording::pictures() const {
    return static_cast<std::size_t>(std::max(1.0, std::round(seconds * perSecond)));
}

FileOrder fileOrder(Recording recording, std::filesystem::path file) {
    const std::size_t pictures = recording.pictures();
    return {
        std::move(file), N_("The animation can't be written: {0}."), pictures,
        [recording = std::move(recording)](const FileMaking& making) { return madeOf(recording, making); }};
}

float recordedSeconds(const Session& session) {
    const RecordingChoice& choice = session.recording;
    const auto rest = static_cast<float>(lengthOf(session.document.scene.timeline)) - choice.begin;
    return choice.seconds.value_or(rest > 0 ? rest : usualSeconds);
}

Result<Recording> recordingOf(const Session& session) {
    const RecordingChoice& choice = session.recording;
    const animation::FormatRow& format = animation::rowOf(choice.format);
    const Document& document = session.document;
    Recording recording{{document.scene, document.images, static_cast<double>(choice.begin), choice.width,
                         choice.height, session.view.anisotropy, session.view.rho},
                        choice.format,
                        static_cast<double>(recordedSeconds(session)),
                        static_cast<double>(choice.perSecond)};
    const auto refuse = [](Sentence words) { return fail(ErrorCode::OutOfRange, std::move(words)); };
    if (!(recording.perSecond > 0 && recording.perSecond <= format.maxPerSecond))
        return refuse({"expected up to {0} pictures a second in a {1}, found {2:g}", format.maxPerSecond,
                       ProperName{format.name}, choice.perSecond});
    const int maxExtent = std::min(format.maxExtent, reference::maxPictureExtent);
    if (std::min(choice.width, choice.height) < 1 || std::max(choice.width, choice.height) > maxExtent)
        return refuse({"expected a picture of up to {0} × {1} pixels in a {2}, found {3} × {4}", maxExtent,
                       maxExtent, ProperName{format.name}, choice.width, choice.height});
    if (!(recording.seconds > 0 && recording.picture.time >= 0 &&
          recording.picture.time + recording.seconds <= double{maxKeyTime}))
        return refuse({"expected an end within {0:g} s, found {1:g} s", maxKeyTime,
                       recording.picture.time + recording.seconds});
    if (recording.pictures() > maxPictures)
        return refuse({"expected at most {0} pictures, found {1}", maxPictures, recording.pictures()});
    return recording;
}

std::string recordingFileName(const Session& session) {
    return fileNameOf(session.document, animation::rowOf(session.recording.format).extension);
}

Result<void> saveRecording(Session& session, const std::filesystem::path& file,
                           const std::optional<FileFingerprint>& replaces) {
    return recordingOf(session).and_then([&](Recording recording) {
        const std::string_view extension = animation::rowOf(recording.format).extension;
        return session.services.writing->writeAs(fileOrder(std::move(recording), file), extension, replaces);
    });
}

} // namespace texplorer::ui

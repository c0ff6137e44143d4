#include "app/ui/model/recordings.h"

#include "app/animation/make_encoder.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "app/view/picture_texts.h"
#include "core/animation/frame_times.h"
#include "core/base/background_thread.h"
#include "core/base/count.h"
#include "core/base/file_io.h"
#include "core/base/parallel.h"
#include "core/base/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords recordingFailure{"there is no memory for the animation",
                                        "the animation can't be made"};
constexpr std::size_t mostPictures = 10'000; // as of texshot animate

FileNews unrecorded(const Error& error) {
    return {fmt::format("The animation can't be written: {}.", describe(error)), false};
}

animation::Settings settingsOf(const Recordings::Order& order) {
    animation::Settings settings{.width = order.picture.width, .height = order.picture.height};
    settings.unitsPerSecond = animation::rowOf(order.format).unitsPerSecond;
    view::PictureFacts facts{order.picture.scene,
                             order.picture.time,
                             {order.picture.width, order.picture.height},
                             std::string(texplorer::rowOf(RendererKind::Reference).name)};
    facts.program = "texplorer";
    settings.texts = view::textsOf(facts);
    return settings;
}

} // namespace

std::size_t Recordings::Order::pictures() const {
    return static_cast<std::size_t>(std::max(1.0, std::round(seconds * perSecond)));
}

struct Recordings::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::Queue, recordingFailure, std::move(wake), levels.stop},
              [this](const Writing::Task& task) { return work(task); },
              [](const Order& /*order*/, const Error& error) { return unrecorded(error); }) {}

    using Writing = Worker<Order, FileNews, FileProgress>;

    std::optional<FileNews> work(const Writing::Task& task) const;

    const LevelWork levels;
    Writing worker; // last: it ends before the rest does
};

std::optional<FileNews> Recordings::State::work(const Writing::Task& task) const {
    const Order& order = task.job();
    if (!task.atOnce())
        giveWay(); // the window goes on
    reference::ReferenceRenderer renderer;
    LevelWork work = levels;
    work.stop = task.stop();
    const unsigned threads = task.atOnce() ? processorThreads() : std::max(1U, processorThreads() / 2);
    auto encoder = animation::makeEncoder(order.format, settingsOf(order));
    if (!encoder)
        return unrecorded(encoder.error());
    const std::size_t all = order.pictures();
    const std::vector<int> durations = animation::durationsOf(all, order.perSecond, order.seconds,
                                                              animation::rowOf(order.format).unitsPerSecond);
    reference::DrawRequest request = order.picture;
    for (std::size_t i = 0; i < all; ++i) {
        task.report({order.file, i, all});
        request.time = order.picture.time + static_cast<double>(i) / order.perSecond;
        const Result<Frame> frame =
            renderer.draw(request, {.threads = threads, .levels = work, .stop = task.stop()});
        if (task.stop().stop_requested())
            return std::nullopt;
        const Result<void> added = frame ? (*encoder)->add(frame->image, durations[i]) : fail(frame.error());
        if (!added)
            return unrecorded(added.error());
    }
    const Result<Bytes> bytes = (*encoder)->finish();
    if (!bytes)
        return unrecorded(bytes.error());
    if (task.stop().stop_requested())
        return std::nullopt;
    if (const Result<void> written = writeFileAtomically(order.file, *bytes); !written)
        return unrecorded(written.error());
    return FileNews{fmt::format("Written: {}", printable(order.file.string())), true};
}

Recordings::Recordings(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

Recordings::~Recordings() = default;

void Recordings::write(Order order) {
    FileProgress progress{order.file, 0, order.pictures()};
    state_->worker.ask(std::move(order), std::move(progress));
}

std::optional<FileProgress> Recordings::progress() const {
    return state_->worker.progress();
}

void Recordings::cancel() {
    state_->worker.drop([](const Order&) { return true; });
}

std::optional<FileNews> Recordings::takeNews() {
    std::vector<FileNews> news = state_->worker.take();
    if (news.empty())
        return std::nullopt;
    return std::move(news.back());
}

void Recordings::wait() const {
    state_->worker.wait();
}

float recordedSeconds(const Session& session) {
    const RecordingChoice& choice = session.window.recording;
    const auto rest = static_cast<float>(lengthOf(session.document.scene.timeline)) - choice.begin;
    return choice.seconds.value_or(rest > 0 ? rest : usualSeconds);
}

Result<Recordings::Order> recordingOrder(const Session& session) {
    const RecordingChoice& choice = session.window.recording;
    const animation::FormatRow& format = animation::rowOf(choice.format);
    const Document& document = session.document;
    Recordings::Order order{{document.scene, document.images, static_cast<double>(choice.begin), choice.width,
                             choice.height, session.window.view.anisotropy},
                            choice.format,
                            static_cast<double>(recordedSeconds(session)),
                            static_cast<double>(choice.perSecond),
                            {}};
    const auto refuse = [](std::string words) { return fail(ErrorCode::OutOfRange, std::move(words)); };
    if (!(order.perSecond > 0 && order.perSecond <= format.mostPerSecond))
        return refuse(fmt::format("expected up to {} pictures a second in a {}, found {:g}",
                                  format.mostPerSecond, format.name, choice.perSecond));
    const int mostExtent = std::min(format.mostExtent, reference::maxPictureExtent);
    if (std::min(choice.width, choice.height) < 1 || std::max(choice.width, choice.height) > mostExtent)
        return refuse(fmt::format("expected a picture of up to {} × {} pixels in a {}, found {} × {}",
                                  mostExtent, mostExtent, format.name, choice.width, choice.height));
    if (!(order.seconds > 0 && order.picture.time >= 0 &&
          order.picture.time + order.seconds <= double{maxKeyTime}))
        return refuse(fmt::format("expected an end within {:g} s, found {:g} s", maxKeyTime,
                                  order.picture.time + order.seconds));
    if (order.pictures() > mostPictures)
        return refuse(fmt::format("expected at most {} pictures, found {}", mostPictures, order.pictures()));
    return order;
}

std::string recordingFileName(const Session& session) {
    const std::string name = nameOf(session.document);
    const animation::FormatRow& format = animation::rowOf(session.window.recording.format);
    return (name.empty() ? "scene" : name) + std::string(format.extension);
}

Result<void> saveRecording(Session& session, const std::filesystem::path& file) {
    endStanding(session);
    Result<Recordings::Order> order = recordingOrder(session);
    if (!order)
        return fail(order.error());
    const animation::FormatRow& format = animation::rowOf(order->format);
    if (file.extension() != format.extension)
        return fail(ErrorCode::Unsupported, fmt::format("expected a name that ends with {}, found \"{}\"",
                                                        format.extension, file.filename().string()));
    order->file = file;
    session.services.recordings.write(*std::move(order));
    return {};
}

} // namespace texplorer::ui

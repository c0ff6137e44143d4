#include "app/ui/model/sheet_files.h"

#include "app/lettering/font_lettering.h"
#include "app/ui/model/session.h"
#include "app/view/picture_texts.h"
#include "core/base/background_thread.h"
#include "core/base/count.h"
#include "core/base/file_io.h"
#include "core/base/parallel.h"
#include "core/base/printable.h"
#include "core/codec/png/png.h"
#include "core/sheet/sheet_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords sheetFileFailure{"there is no memory for the sheet", "the sheet can't be made"};
constexpr std::string_view referenceName = rowOf(RendererKind::Reference).name;

FileNews unwritten(const Error& error) {
    return {fmt::format("The sheet can't be written: {}.", describe(error)), false};
}

std::vector<PictureText> textsOfSheet(const SheetFiles::Order& order) {
    view::PictureFacts facts{order.picture.scene,
                             order.picture.time,
                             {order.picture.width, order.picture.height},
                             std::string(referenceName)};
    for (const SweepAxis* axis : {&order.rows, &order.columns})
        facts.axes.push_back(view::axisText(*axis, axis->values));
    facts.program = "texplorer";
    return view::textsOf(facts);
}

} // namespace

struct SheetFiles::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::Queue, sheetFileFailure, std::move(wake), levels.stop},
              [this](const Writing::Task& task) { return work(task); },
              [](const Job& /*job*/, const Error& error) { return unwritten(error); }) {}

    struct Job {
        Order order;
        sheet::Layout layout;
        const sheet::Lettering* lettering = nullptr;
    };
    using Writing = Worker<Job, FileNews, FileProgress>;

    /// nullptr and why: there are no fonts.
    [[nodiscard]] Result<const sheet::Lettering*> pen() {
        if (!lettering)
            lettering = openLettering();
        if (!*lettering)
            return fail(lettering->error());
        return (*lettering)->get();
    }

    std::optional<FileNews> work(const Writing::Task& task);

    std::optional<Result<std::unique_ptr<sheet::Lettering>>> lettering; ///< once it was asked for
    const LevelWork levels;

    Writing worker; // last: it ends before the rest does
};

std::optional<FileNews> SheetFiles::State::work(const Writing::Task& task) {
    const auto& [order, layout, pen] = task.job();
    if (!task.atOnce())
        giveWay(); // the window goes on
    reference::ReferenceRenderer renderer;
    LevelWork work = levels;
    work.stop = task.stop();
    const unsigned threads = task.atOnce() ? processorThreads() : std::max(1U, processorThreads() / 2);
    sheet::SheetPicture picture(layout);
    const std::size_t columns = order.columns.values.size();
    const std::size_t all = layout.cells.size();
    std::size_t refused = 0;
    std::string firstRefusal;
    for (std::size_t cell = 0; cell < all; ++cell) {
        task.report({order.file, cell, all});
        reference::DrawRequest request = order.picture;
        Result<Scene> scene =
            sheetScene(order.picture.scene, order.rows, cell / columns, order.columns, cell % columns);
        if (scene)
            request.scene = *std::move(scene);
        const Result<Frame> frame =
            scene ? renderer.draw(request, {.threads = threads, .levels = work, .stop = task.stop()})
                  : fail(scene.error());
        if (task.stop().stop_requested())
            return std::nullopt;
        if (frame) {
            picture.put(cell, frame->image);
            continue;
        }
        const std::string words = describe(frame.error());
        picture.refuse(cell, printable(words));
        if (refused++ == 0)
            firstRefusal = words;
    }
    if (refused == all)
        return FileNews{
            fmt::format("The sheet is not written, because none of its pictures can be drawn: {}.",
                        firstRefusal),
            false};
    const Result<Bytes> bytes =
        encodePng(std::move(picture).take(*pen), WriteOptions{.texts = textsOfSheet(order)});
    if (!bytes)
        return unwritten(bytes.error());
    if (task.stop().stop_requested())
        return std::nullopt;
    if (const Result<void> written = writeFileAtomically(order.file, *bytes); !written)
        return unwritten(written.error());
    const std::string file = printable(order.file.string());
    return refused == 0 ? FileNews{fmt::format("Written: {}", file), true}
                        : FileNews{fmt::format("Written: {}. {} of {} can't be drawn, and say why.", file,
                                               refused, countOf(all, "picture")),
                                   false};
}

SheetFiles::SheetFiles(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

SheetFiles::~SheetFiles() = default;

Result<sheet::Layout> SheetFiles::layoutOf(const sheet::Content& content) {
    const Result<const sheet::Lettering*> pen = state_->pen();
    if (!pen)
        return fail(pen.error());
    return sheet::layoutOf(content, **pen);
}

Result<void> SheetFiles::write(Order order) {
    Result<sheet::Layout> layout = layoutOf(order.content);
    if (!layout)
        return fail(layout.error());
    FileProgress progress{order.file, 0, layout->cells.size()};
    state_->worker.ask({std::move(order), *std::move(layout), *state_->pen()}, std::move(progress));
    return {};
}

std::optional<FileProgress> SheetFiles::progress() const {
    return state_->worker.progress();
}

void SheetFiles::cancel() {
    state_->worker.drop([](const State::Job&) { return true; });
}

std::optional<FileNews> SheetFiles::takeNews() {
    std::vector<FileNews> news = state_->worker.take();
    if (news.empty())
        return std::nullopt;
    return std::move(news.back());
}

void SheetFiles::wait() const {
    state_->worker.wait();
}

Result<SheetFiles::Order> sheetOrder(const Session& session) {
    Result<std::array<SweepAxis, 2>> axes = sweptAxes(session);
    if (!axes)
        return fail(axes.error());
    const SheetChoice& choice = session.window.sheet;
    const std::size_t rows = axes->front().values.size();
    const std::size_t columns = axes->back().values.size();
    if (rows * columns > sheet::maxPictures) // each has at most maxAxisValues
        return fail(ErrorCode::TooLarge, fmt::format("expected at most {} pictures on a sheet, found {} × {}",
                                                     sheet::maxPictures, rows, columns));
    const Document& document = session.document;
    std::vector<sheet::AxisLabels> labels = sheet::labelsOf(document.scene, *axes, choice.labels);
    const std::string name = nameOf(document);
    sheet::Content content{.title = name.empty() ? "Default scene" : printable(name)};
    content.cell = {choice.width, choice.height};
    content.down = std::move(labels[0]);
    content.across = std::move(labels[1]);
    return SheetFiles::Order{{document.scene, document.images, session.window.playback.time, choice.width,
                              choice.height, session.window.view.anisotropy},
                             std::move(axes->front()),
                             std::move(axes->back()),
                             std::move(content),
                             {}};
}

std::string sheetFileName(const Document& document) {
    const std::string name = nameOf(document);
    return (name.empty() ? "scene" : name) + "-sheet.png";
}

Result<glm::ivec2> sheetExtent(Session& session) {
    const Result<SheetFiles::Order> order = sheetOrder(session);
    if (!order)
        return fail(order.error());
    const Result<sheet::Layout> layout = session.services.sheetFiles.layoutOf(order->content);
    if (!layout)
        return fail(layout.error());
    return layout->size;
}

Result<void> saveSheet(Session& session, const std::filesystem::path& file) {
    Result<SheetFiles::Order> order = sheetOrder(session);
    if (!order)
        return fail(order.error());
    if (file.extension() != ".png")
        return fail(ErrorCode::Unsupported, fmt::format("expected a name that ends with .png, found \"{}\"",
                                                        file.filename().string()));
    order->file = file;
    return session.services.sheetFiles.write(*std::move(order));
}

} // namespace texplorer::ui

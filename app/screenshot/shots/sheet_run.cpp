#include "app/screenshot/shots/sheet_run.h"

#include "app/screenshot/gl/picture_texts.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/shots/drawing.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/base/tried.h"
#include "texplorer/sheet/changes.h"
#include "texplorer/sheet/sheet_picture.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace texplorer::screenshot {
namespace {

AxisValues valuesOf(const ShotList& list, std::size_t index) {
    const ShotList::Case picture = list.at(index);
    const std::vector<SweepAxis>& axes = list.entryOf(picture).axes;
    AxisValues values;
    for (std::size_t i = 0; i < axes.size(); ++i)
        values.emplace_back(axes[i].path, axes[i].values[picture.values[i]]);
    return values;
}

/// What sentences call each picture: "textures[0].wrapS=GL_CLAMP".
std::vector<std::string> pictureNames(const ShotList& list) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < list.count(); ++i) {
        std::string name;
        for (const auto& [path, value] : valuesOf(list, i))
            name += fmt::format("{}{}={}", name.empty() ? "" : " ", path, value);
        names.push_back(std::move(name));
    }
    return names;
}

/// Fills sheets with pictures as they come, and writes each that is full.
class Sheets {
public:
    Sheets(const SheetRun& run, const LongWork& work)
        : run_(run)
        , stop_(work.stopToken())
        , cells_(run.list.count() / run.pages.size())
        , pages_(run.pages.size()) {}

    /// From any thread.
    void take(const DrawnShot& drawn) {
        const Result<void> taken = tried({"not enough memory for the sheet", "the sheet can't be made"},
                                         [&]() -> Result<void> { return put(drawn); });
        if (!taken)
            fail(taken.error());
    }

    [[nodiscard]] std::optional<Error> failure() const {
        const std::scoped_lock lock(mutex_);
        return failure_;
    }
    [[nodiscard]] std::size_t written() const {
        const std::scoped_lock lock(mutex_);
        return written_;
    }

    /// Those of which every cell is done, written or not worth it.
    [[nodiscard]] std::size_t finished() const {
        const std::scoped_lock lock(mutex_);
        return finished_;
    }

    /// Of all that were written, in the order of the pages. When no more pictures come.
    [[nodiscard]] std::vector<WrittenSheet> takeWritten() {
        std::vector<WrittenSheet> sheets;
        for (Page& page : pages_) {
            if (page.sheet)
                sheets.push_back(*std::move(page.sheet));
        }
        return sheets;
    }

private:
    struct Page {
        std::optional<sheet::SheetPicture> picture{}; ///< from its first cell on until it is full
        std::optional<PictureFacts> facts{};          ///< of a cell that was drawn; none: there is none yet
        std::vector<SheetCell> cells{};
        std::size_t taken = 0;
        std::optional<WrittenSheet> sheet{};
    };

    Result<void> put(const DrawnShot& drawn) {
        const std::size_t number = drawn.index / cells_;
        const std::size_t cell = drawn.index % cells_;
        Page& page = begun(number, drawn);
        SheetCell& told = page.cells[cell];
        if (!drawn.shot) {
            told.error = drawn.shot.error();
            page.picture->refuse(cell, printable(describe(*told.error)));
            if (drawn.index == 0)
                settleFirst({});
        } else if (const Result<void> shown =
                       show(page, cell, told, drawn.index, std::move(drawn.shot->frame.image));
                   !shown) {
            return shown;
        }
        told.warnings = drawn.warnings;
        {
            const std::scoped_lock lock(mutex_);
            if (++page.taken < cells_)
                return {};
        }
        return finish(number);
    }

    /// The page, with what its texts say where this is the first of its pictures that was drawn.
    Page& begun(std::size_t number, const DrawnShot& drawn) {
        const std::scoped_lock lock(mutex_);
        Page& page = pages_[number];
        const SheetRun::Page& asked = run_.pages[number];
        if (!page.picture) {
            page.picture.emplace(asked.layout);
            for (std::size_t i = 0; i < cells_; ++i)
                page.cells.push_back({asked.layout.cells[i], valuesOf(run_.list, number * cells_ + i)});
        }
        if (!page.facts && drawn.shot) {
            page.facts = factsOf(drawn.request, *drawn.shot);
            page.facts->scene = asked.scene;
            page.facts->axes = asked.axes;
        }
        return page;
    }

    Result<void> show(Page& page, std::size_t cell, SheetCell& told, std::size_t index, Image picture) {
        if (!run_.difference || index == 0) {
            page.picture->put(cell, picture);
            if (run_.difference) {
                page.picture->note(cell, "the first");
                settleFirst(std::move(picture));
            }
            return {};
        }
        const Image* first = waitForFirst();
        if (first == nullptr) {
            told.error =
                Error{ErrorCode::Unsupported, N_("there is no first picture to compare it with"), {}};
            page.picture->refuse(cell, told.error->message);
            return {};
        }
        const Result<sheet::PictureChanges> changes = sheet::changesAgainst(*first, picture);
        if (!changes)
            return tl::unexpected(changes.error());
        told.differing = changes->pixels;
        page.picture->put(cell, changes->map);
        page.picture->note(cell, wordsOfDifference(changes->pixels));
        return {};
    }

    /// An empty one: it can't be drawn.
    void settleFirst(Image picture) {
        {
            const std::scoped_lock lock(mutex_);
            first_ = std::move(picture);
            firstSettled_ = true;
        }
        settled_.notify_all();
    }

    /// nullptr: there will be none.
    const Image* waitForFirst() {
        std::unique_lock lock(mutex_);
        settled_.wait(lock, stop_, [this] { return firstSettled_; });
        return first_.empty() ? nullptr : &first_;
    }

    Result<void> finish(std::size_t number) {
        const SheetRun::Page& asked = run_.pages[number];
        Page& page = pages_[number];
        if (!page.facts) { // no picture at all
            page.picture.reset();
            const std::scoped_lock lock(mutex_);
            ++finished_;
            return {};
        }
        Image image = std::move(*page.picture).take(run_.lettering);
        page.picture.reset();
        WriteOptions options;
        if (run_.withTexts)
            options.texts = textsOf(*page.facts);
        if (const Result<void> written = asked.output.write(textureOf(std::move(image), {}), options);
            !written)
            return written;
        const std::scoped_lock lock(mutex_);
        ++finished_;
        ++written_;
        page.sheet =
            WrittenSheet{asked.output.path, asked.layout.size, *std::move(page.facts), std::move(page.cells)};
        return {};
    }

    void fail(const Error& error) {
        {
            const std::scoped_lock lock(mutex_);
            if (!failure_)
                failure_ = error;
            firstSettled_ = true; // nobody waits any longer
        }
        settled_.notify_all();
    }

    const SheetRun& run_;
    const std::stop_token stop_;
    const std::size_t cells_;  ///< of a page
    std::vector<Page> pages_;  // each cell is its thread's own; the rest is guarded
    mutable std::mutex mutex_; // guards what follows
    std::condition_variable_any settled_;
    Image first_; ///< what the others are compared with; nobody changes it once it is settled
    bool firstSettled_ = false;
    std::size_t finished_ = 0;
    std::size_t written_ = 0;
    std::optional<Error> failure_;
};

} // namespace

std::string wordsOfDifference(std::size_t pixels) {
    if (pixels == 0)
        return "no pixel differs";
    return fmt::format("{} differ{}", Sentence::plural("{0} pixel", "{0} pixels", pixels),
                       pixels == 1 ? "s" : "");
}

ExitCode drawSheets(const SheetRun& run) {
    LongWork work("texshot: drawing");
    Sheets sheets(run, work);
    const std::vector<std::string> names = pictureNames(run.list);
    const DrawingEnd end = drawList({.list = run.list,
                                     .names = names,
                                     .common = run.common,
                                     .work = work,
                                     .take = [&](const DrawnShot& drawn) { sheets.take(drawn); },
                                     .goesOn = [&] { return !sheets.failure(); }});
    work.finish();
    for (const Error& each : end.warnings)
        warn(each);
    if (const std::optional<Error> lost = sheets.failure())
        return complain(*lost);
    if (work.stopToken().stop_requested() && sheets.finished() < run.pages.size())
        return complainInterrupted(
            sheets.written() > 0 ? Sentence("{0} of {1} were written", sheets.written(),
                                            Sentence::plural("{0} sheet", "{0} sheets", run.pages.size()))
                                 : Sentence());
    if (end.unopened)
        return complain(*end.unopened);
    if (run.written != nullptr)
        *run.written = sheets.takeWritten();
    return end.complete ? success : failure;
}

} // namespace texplorer::screenshot

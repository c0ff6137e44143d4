#include "app/ui/services/file_writing.h"

#include "app/ui/services/free_name.h"
#include "texplorer/base/background_thread.h"
#include "texplorer/base/parallel.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords fileFailure{"not enough memory for it", "it can't be created"};

constexpr const char* meanwhile = "Another program has written the other file meanwhile.";

FileNews unwritten(const FileOrder& order, const Error& error) {
    return {fmt::format(fmt::runtime(order.failure), describe(error)), false};
}

} // namespace

std::size_t FileProgress::picturesDrawn() const {
    return static_cast<std::size_t>(std::lround(static_cast<double>(share) * static_cast<double>(pictures)));
}

struct FileWriting::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::Queue, fileFailure, std::move(wake), levels.stop},
              [this](const Writing::Task& task) { return work(task); }, unwritten) {}

    using Writing = Worker<FileOrder, FileNews, FileProgress>;

    [[nodiscard]] std::optional<FileNews> work(const Writing::Task& task);
    [[nodiscard]] Result<std::filesystem::path> write(const FileOrder& order, ByteView bytes);

    const LevelWork levels;
    /// The files that it has written, which a later order of the same name replaces. Used only on the working
    /// thread.
    std::map<std::filesystem::path, FileFingerprint> own;
    Writing worker; // last member: it ends before the others
};

Result<std::filesystem::path> FileWriting::State::write(const FileOrder& order, ByteView bytes) {
    const auto before = own.find(order.file);
    const bool isOwn = before != own.end() && fingerprintOf(order.file) == before->second;
    Result<std::filesystem::path> written =
        writeFreely(order.file, bytes, isOwn ? before->second : order.replaces);
    if (const auto now = written ? fingerprintOf(*written) : std::nullopt)
        own[*written] = *now;
    return written;
}

std::optional<FileNews> FileWriting::State::work(const Writing::Task& task) {
    const FileOrder& order = task.job();
    if (!task.atOnce())
        giveWay(); // the window has priority
    FileMaking making{.threads = task.atOnce() ? processorThreads() : std::max(1U, processorThreads() / 2),
                      .levels = levels,
                      .report = [&](float share) {
                          task.report({order.file, order.pictures, share});
                      }};
    making.levels.stop = task.stop();
    making.report(0);
    Result<MadeFile> made = order.make(making);
    if (task.stop().stop_requested())
        return std::nullopt;
    if (!made)
        return unwritten(order, made.error());
    const Result<std::filesystem::path> written = write(order, made->bytes);
    if (!written)
        return unwritten(order, written.error());
    if (*written != order.file)
        made->remark = made->remark.empty() ? meanwhile : fmt::format("{} {}", meanwhile, made->remark);
    const std::string file = printable(written->string());
    if (made->remark.empty())
        return FileNews{fmt::format("Written: {}", file), true};
    return FileNews{fmt::format("Written: {}. {}", file, made->remark), false};
}

FileWriting::FileWriting(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

FileWriting::~FileWriting() = default;

void FileWriting::write(FileOrder order) {
    FileProgress progress{order.file, order.pictures};
    state_->worker.ask(std::move(order), std::move(progress));
}

std::optional<FileProgress> FileWriting::progress() const {
    return state_->worker.progress();
}

void FileWriting::cancel() {
    state_->worker.drop([](const FileOrder&) { return true; });
}

std::optional<FileNews> FileWriting::takeNews() {
    std::vector<FileNews> news = state_->worker.take();
    if (news.empty())
        return std::nullopt;
    const auto bad = std::ranges::find(news, false, &FileNews::isGood);
    return std::move(bad != news.end() ? *bad : news.back());
}

void FileWriting::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::ui

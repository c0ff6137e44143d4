#include "app/ui/services/file_writing.h"

#include "app/ui/services/free_name.h"
#include "texplorer/base/background_thread.h"
#include "texplorer/base/parallel.h"
#include "texplorer/text/printable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords fileFailure{N_("not enough memory for it"), N_("it can't be created")};

constexpr const char* meanwhile = N_("Another program has written the other file meanwhile.");

FileNews unwritten(const FileOrder& order, const Error& error) {
    return {Sentence(order.failure, describe(error)), false};
}

} // namespace

std::size_t FileProgress::picturesDrawn() const {
    return static_cast<std::size_t>(std::lround(static_cast<double>(share) * static_cast<double>(pictures)));
}

FileWriting::FileWriting(When when, std::function<void()> wake, LevelWork levels)
    : levels_(std::move(levels))
    , worker_(
          {when, JobOrder::Queue, fileFailure, std::move(wake), levels_.stop},
          [this](const Writing::Task& task) { return work(task); }, unwritten) {}

Result<std::filesystem::path> FileWriting::put(const FileOrder& order, ByteView bytes) {
    const auto before = own_.find(order.file);
    const bool isOwn = before != own_.end() && fingerprintOf(order.file) == before->second;
    Result<std::filesystem::path> written =
        writeFreely(order.file, bytes, isOwn ? before->second : order.replaces);
    if (const auto now = written ? fingerprintOf(*written) : std::nullopt)
        own_[*written] = *now;
    return written;
}

std::optional<FileNews> FileWriting::work(const Writing::Task& task) {
    const FileOrder& order = task.job();
    if (!task.atOnce())
        giveWay(); // the window has priority
    FileMaking making{.threads = task.atOnce() ? processorThreads() : std::max(1U, processorThreads() / 2),
                      .levels = levels_,
                      .report = [&](float share) {
                          task.report({order.file, order.pictures, share});
                      }};
    making.levels.stop = task.stop();
    making.report(0);
    Result<MadeFile> made = order.make(making);
    if (task.stop().stop_requested())
        return std::nullopt;
    return finish(order, std::move(made));
}

FileNews FileWriting::finish(const FileOrder& order, Result<MadeFile> made) {
    if (!made)
        return unwritten(order, made.error());
    const Result<std::filesystem::path> written = put(order, made->bytes);
    if (!written)
        return unwritten(order, written.error());
    if (*written != order.file)
        made->remark = made->remark.empty() ? meanwhile : Sentence("{0} {1}", meanwhile, made->remark);
    const std::string name = printable(written->string());
    const ProperName file{name};
    if (made->remark.empty())
        return {Sentence("Written: {0}", file), true};
    return {Sentence("Written: {0}. {1}", file, made->remark), false};
}

void FileWriting::write(FileOrder order) {
    FileProgress progress{order.file, order.pictures};
    worker_.ask(std::move(order), std::move(progress));
}

Result<void> FileWriting::writeAs(FileOrder order, std::string_view extension,
                                  const std::optional<FileFingerprint>& replaces) {
    if (order.file.extension() != extension)
        return fail(ErrorCode::Unsupported,
                    Sentence("expected a name that ends with {0}, found \"{1}\"", ProperName{extension},
                             ProperName{order.file.filename().string()}));
    order.replaces = replaces;
    write(std::move(order));
    return {};
}

std::optional<FileNews> FileWriting::takeNews() {
    std::vector<FileNews> news = take();
    if (news.empty())
        return std::nullopt;
    const auto bad = std::ranges::find(news, false, &FileNews::isGood);
    return std::move(bad != news.end() ? *bad : news.back());
}

} // namespace texplorer::ui

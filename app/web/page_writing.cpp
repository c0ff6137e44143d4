#include "app/web/page_writing.h"

#include "app/web/browser.h"

namespace texplorer::web {

void PageWriting::write(ui::FileOrder order) {
    waiting_.push_back(std::move(order));
    if (waiting_.size() == 1)
        startNext();
}

void PageWriting::startNext() {
    while (!waiting_.empty()) {
        share_ = 0;
        worker_ = browser::makeFileInCopy(&waiting_.front());
        if (worker_ != 0)
            return;
        makeHere();
    }
}

void PageWriting::makeHere() {
    FileWriting::write(std::move(waiting_.front()));
    waiting_.pop_front();
}

std::optional<ui::FileProgress> PageWriting::progress() const {
    if (waiting_.empty())
        return std::nullopt;
    return ui::FileProgress{waiting_.front().file, waiting_.front().pictures, share_};
}

void PageWriting::cancel() {
    if (worker_ != 0)
        browser::dropWorker(std::exchange(worker_, 0));
    waiting_.clear();
}

void PageWriting::end(Result<ui::MadeFile> file) {
    browser::dropWorker(std::exchange(worker_, 0));
    news_.push_back(finish(waiting_.front(), std::move(file)));
    waiting_.pop_front();
    startNext();
}

void PageWriting::failed(const Sentence& reason) {
    if (!reason.empty())
        return end(fail(ErrorCode::Unsupported, reason));
    browser::dropWorker(std::exchange(worker_, 0));
    makeHere();
    startNext();
}

Result<std::filesystem::path> PageWriting::put(const ui::FileOrder& order, ByteView bytes) {
    const std::string name = order.file.string();
    browser::saveFile(name.data(), lengthOf(name), bytes.data(), lengthOf(bytes));
    return order.file;
}

std::vector<ui::FileNews> PageWriting::take() {
    std::vector<ui::FileNews> news = FileWriting::take(); // of files without a copy
    news.insert(news.begin(), news_.begin(), news_.end());
    news_.clear();
    return news;
}

} // namespace texplorer::web

#include "app/ui/services/files.h"

#include <utility>

namespace texplorer::ui {

FilesBeside::FilesBeside(const std::function<void()>& wake)
    : loader_(wake)
    , thumbnails_(wake)
    , watch_(wake) {}

Files::Ticket FilesBeside::load(std::filesystem::path path, Wanted wanted) {
    return loader_.load(std::move(path), wanted);
}

void FilesBeside::cancel(Ticket ticket) {
    loader_.cancel(ticket);
}

std::vector<ImageLoader::Loaded> FilesBeside::take() {
    return loader_.take();
}

std::optional<ImageLoader::Progress> FilesBeside::progress() const {
    return loader_.progress();
}

void FilesBeside::watch(std::vector<std::filesystem::path> files) {
    watch_.watch(std::move(files));
}

std::vector<std::filesystem::path> FilesBeside::changed() {
    return watch_.changed();
}

void FilesBeside::askThumbnail(const std::filesystem::path& file, std::filesystem::file_time_type modified) {
    thumbnails_.ask(file, modified);
}

std::shared_ptr<const Image> FilesBeside::thumbnail(const std::filesystem::path& file) const {
    return thumbnails_.find(file);
}

bool FilesBeside::receiveThumbnails() {
    return thumbnails_.receive();
}

void FilesBeside::wait() const {
    loader_.wait();
    thumbnails_.wait();
}

Files::Ticket FilesAtOnce::load(std::filesystem::path path, Wanted wanted) {
    Result<ImageLoader::Content> content = loadNow(path, wanted);
    loaded_.push_back({++last_, std::move(path), std::move(content)});
    return last_;
}

void FilesAtOnce::cancel(Ticket ticket) {
    std::erase_if(loaded_, [ticket](const ImageLoader::Loaded& each) { return each.ticket == ticket; });
}

std::vector<ImageLoader::Loaded> FilesAtOnce::take() {
    return std::exchange(loaded_, {});
}

} // namespace texplorer::ui

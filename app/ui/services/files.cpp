#include "app/ui/services/files.h"

#include <utility>

namespace texplorer::ui {

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

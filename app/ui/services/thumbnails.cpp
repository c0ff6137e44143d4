#include "app/ui/services/thumbnails.h"

#include <algorithm>

namespace texplorer::ui {

void Thumbnails::ask(const std::filesystem::path& file, std::filesystem::file_time_type modified) {
    Slot& slot = slots_[file];
    const bool isNew = slot.frame == 0;
    slot.frame = frame_ + 1;
    if (isNew || slot.modified != modified) {
        if (slot.ticket != 0)
            loader_.cancel(slot.ticket);
        slot.modified = modified;
        slot.ticket = loader_.load(file, ImageLoader::Wanted::Thumbnail);
    }
}

std::shared_ptr<const Image> Thumbnails::find(const std::filesystem::path& file) const {
    const auto slot = slots_.find(file);
    return slot == slots_.end() ? nullptr : slot->second.image;
}

bool Thumbnails::receive() {
    bool any = false;
    for (ImageLoader::Loaded& loaded : loader_.take()) {
        const auto slot = slots_.find(loaded.path);
        if (slot == slots_.end() || slot->second.ticket != loaded.ticket)
            continue;
        slot->second.ticket = 0;
        if (loaded.content)
            slot->second.image = std::make_shared<const Image>(std::get<Image>(std::move(*loaded.content)));
        any = true;
    }
    std::erase_if(slots_, [this](const auto& entry) {
        const bool forsaken = entry.second.ticket != 0 && entry.second.frame != frame_ + 1;
        if (forsaken)
            loader_.cancel(entry.second.ticket);
        return forsaken;
    });
    makeRoom();
    ++frame_;
    return any;
}

void Thumbnails::makeRoom() {
    while (slots_.size() > maxPictures) {
        const auto oldest =
            std::ranges::min_element(slots_, {}, [](const auto& entry) { return entry.second.frame; });
        if (oldest->second.ticket != 0)
            loader_.cancel(oldest->second.ticket);
        slots_.erase(oldest);
    }
}

} // namespace texplorer::ui

#include "core/reference/texture_store.h"

#include "core/reference/completeness.h"

#include <algorithm>

namespace texplorer::reference {

void TextureStore::fill(Slot& slot, Target target, const LevelWork& work, const std::string& where) {
    const Result<TextureLevels> levels = prepareLevels(slot.settings, *slot.image, target, work);
    if (!levels) {
        slot.notes.push_back(where + ": " + describe(levels.error()) + "; drawn without it");
        return;
    }
    slot.notes = levels->notes;
    slot.texture.sampled = sampledTexture(slot.settings, *levels, target, slot.notes);
    slot.texture.lateFlip = levels->lateFlip;
    slot.lastLevel = levels->lastLevel;
    slot.usable = true;
    for (std::string& note : slot.notes)
        note = where + ": " + note;
}

const StoredTexture* TextureStore::prepare(const Scene& scene, std::size_t index, Target target,
                                           const ImageSource& images, const LevelWork& work,
                                           std::vector<std::string>& problems) {
    const Texture& texture = scene.textures[index];
    const std::string where = "textures[" + std::to_string(index) + "]";
    const auto say = [&problems](const std::string& sentence) {
        if (std::ranges::find(problems, sentence) == problems.end())
            problems.push_back(sentence);
    };
    std::shared_ptr<const TextureImage> image = images.find(texture);
    if (!image || image->surfaces.empty() || byteCount(image->surfaces.front()) == 0) {
        say(where + ": " + (texture.file.empty() ? "no file is chosen" : texture.file + " is not loaded") +
            "; drawn without it");
        return nullptr;
    }
    Slot& slot = slots_[{index, target}];
    if (Texture settings = imageSettings(texture); slot.image != image || slot.settings != settings) {
        slot = Slot{};
        slot.image = std::move(image);
        slot.settings = std::move(settings);
        fill(slot, target, work, where);
        if (work.stop.stop_requested()) // half done: begin again next time
            slot.image.reset();
    }
    std::ranges::for_each(slot.notes, say);
    if (!slot.usable)
        return nullptr;
    setParameters(slot.texture.sampled, texture, slot.lastLevel);
    slot.texture.complete = checkCompleteness(slot.texture.sampled).complete();
    return &slot.texture;
}

void TextureStore::keepFirst(std::size_t count) {
    std::erase_if(slots_, [count](const auto& entry) { return entry.first.first >= count; });
}

} // namespace texplorer::reference

#include "texplorer/reference/drawn_pictures.h"

#include "texplorer/scene/params/scene_at.h"

#include <algorithm>
#include <utility>

namespace texplorer::reference {

namespace {

/// The new picture, or the one before if it has the same pixels.
std::shared_ptr<const TextureImage> keptOrNew(const ImageSource& before, const PictureKey& key, Image image) {
    const auto known = before.pictures().find(key);
    if (known != before.pictures().end() && std::get<Image>(known->second->surfaces.front()) == image)
        return known->second;
    return drawnImage(std::move(image));
}

} // namespace

Result<ImageSource> DrawnPictures::addedTo(const ImageSource& images, const Scene& scene, double time,
                                           const DrawPicture& draw, std::uint64_t revision) {
    const StandingScene now(scene, time);
    const std::vector<PictureKey> wanted = shownPictures(*now);
    if (std::ranges::all_of(wanted, [&](const PictureKey& key) { return images.holdsPicture(key); })) {
        *this = {};
        return images;
    }
    Seen seen{scene, images, time, revision};
    if (seen_ == seen)
        return drawn_;
    ImageSource all = images;
    for (int frame = shownFrames(*now) - 1; frame >= 0; --frame) {
        const double then = std::max(std::min(time, 0.0), time - frame * frameInterval);
        const StandingScene standing(scene, then);
        for (const PictureKey& key : shownPictures(*standing)) {
            if (images.holdsPicture(key))
                continue;
            Result<Image> picture = draw(picturedScene(*standing, key.number), all, then, key.size);
            if (!picture)
                return fail(picture.error());
            all.putPicture(key, keptOrNew(frame == 0 ? drawn_ : all, key, std::move(*picture)));
        }
    }
    seen_ = std::move(seen);
    drawn_ = all;
    return all;
}

} // namespace texplorer::reference

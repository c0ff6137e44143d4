#include "texplorer/scene/pass_pictures.h"

#include "texplorer/scene/drawn_models.h"

#include <algorithm>

namespace texplorer {

namespace {

template<class Visit> ///< visit(texture)
void forEachShown(const Scene& scene, Visit visit) {
    for (const Pass& pass : scene.passes) {
        for (const Unit& unit : pass.units) {
            const auto texture = static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
            if (pass.enabled && unit.enabled && texture < scene.textures.size() &&
                scene.textures[texture].source == SourceKind::Picture)
                visit(texture);
        }
    }
}

} // namespace

Scene picturedScene(const Scene& scene, int picture) {
    Scene drawn = scene;
    for (Pass& pass : drawn.passes)
        pass.enabled = pass.enabled && pass.picture == picture;
    return drawn;
}

bool hasPictures(const Scene& scene) {
    return std::ranges::any_of(scene.passes, [](const Pass& pass) { return pass.picture != 0; });
}

std::vector<PictureKey> shownPictures(const Scene& scene) {
    std::vector<std::size_t> textures;
    forEachShown(scene, [&](std::size_t texture) { textures.push_back(texture); });
    std::ranges::sort(textures);
    std::vector<PictureKey> keys;
    for (const std::size_t texture : textures) {
        const PictureKey key = pictureOf(scene.textures[texture]);
        if (std::ranges::find(keys, key) == keys.end())
            keys.push_back(key);
    }
    return keys;
}

bool isSeen(const Scene& scene, const Pass& pass) {
    const std::vector<PictureKey> shown = shownPictures(scene);
    return pass.picture == 0 || std::ranges::find(shown, pass.picture, &PictureKey::number) != shown.end();
}

std::vector<UnfinishedRead> unfinishedReads(const Scene& scene) {
    const std::vector<PictureKey> order = shownPictures(scene);
    std::vector<UnfinishedRead> reads;
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const Pass& pass = scene.passes[p];
        const auto drawn = std::ranges::find(order, pass.picture, &PictureKey::number);
        if (drawn == order.end() || !drawsAnything(scene, pass))
            continue;
        for (const Unit& unit : pass.units) {
            const auto texture = static_cast<std::size_t>(unit.texture);
            if (unit.enabled && texture < scene.textures.size() &&
                scene.textures[texture].source == SourceKind::Picture &&
                std::ranges::find(order, pictureOf(scene.textures[texture])) >= drawn)
                reads.push_back({p, texture});
        }
    }
    return reads;
}

int shownFrames(const Scene& scene) {
    int frames = 1;
    forEachShown(scene,
                 [&](std::size_t texture) { frames = std::max(frames, scene.textures[texture].frames); });
    return frames;
}

} // namespace texplorer

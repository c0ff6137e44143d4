#include "texplorer/scene/params/timeline_check.h"

#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/scene_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace texplorer {
namespace {

bool isOfTimeline(const Scene& scene, std::string_view path) {
    const auto row = rowAt(scene, path);
    const auto rows = keyFrameTable().params;
    return row && *row >= rows.data() && *row < rows.data() + rows.size();
}

/// Whether a parameter is one of those that decide together whether a unit has its texture.
bool bindsTexture(const Scene& scene, std::string_view path) {
    const auto row = rowAt(scene, path);
    return row && ((*row)->member == memberId<&Unit::texture> || (*row)->member == memberId<&Unit::enabled>);
}

/// Both go in steps: what holds between two keys holds at the first of them.
Result<void> checkTextures(const Scene& scene) {
    std::vector<Track> tracks = tracksOf(scene.timeline);
    std::erase_if(tracks, [&](const Track& track) { return !bindsTexture(scene, track.path); });
    std::set<float> times;
    for (const Track& track : tracks)
        for (const KeyFrame* key : track.keys)
            times.insert(key->time);
    Scene standing; // only its passes are used
    standing.passes = scene.passes;
    standing.textures.resize(scene.textures.size());
    for (const float time : times) {
        for (const Track& track : tracks) {
            const std::string& value = momentOf(track, double{time}).from->value;
            if (auto put = putBetween(standing, track.path, value, value, 0); !put)
                return put;
        }
        for (std::size_t p = 0; p < standing.passes.size(); ++p)
            for (std::size_t u = 0; u < maxUnits; ++u)
                if (auto fits = checkUnitTexture(standing, standing.passes[p].units[u]); !fits)
                    return fail(fits.error().code,
                                Sentence("{0}.{1}, at {2} s: {3}", ProperName{elementOf<&Scene::passes>(p)},
                                         ProperName{elementOf<&Pass::units>(u)},
                                         ProperName{formatNumber(time)}, fits.error().message));
    }
    return {};
}

} // namespace

Result<void> checkKey(const Scene& scene, const KeyFrame& key) {
    if (key.path.empty())
        return fail(ErrorCode::OutOfRange,
                    "expected the path of a parameter, as \"view.azimuth\", found none", atPointer("/path"));
    if (const auto row = rowAt(scene, key.path); !row)
        return fail(row.error().code,
                    Sentence("{0}: {1}", ProperName{row.error().where.text()}, row.error().message),
                    atPointer("/path"));
    if (auto fits = checkMovable(scene, key.path, key.value); !fits)
        return fail(fits.error().code,
                    Sentence("{0}: {1}", ProperName{shortened(key.path)}, fits.error().message),
                    atPointer(isOfTimeline(scene, key.path) ? "/path" : "/value"));
    return {};
}

Result<void> checkEditedKey(const Scene& scene, const KeyFrame& key, const ParamRow& edited) {
    auto fits = checkKey(scene, key);
    if (fits || (edited.member != memberId<&KeyFrame::value> && edited.member != memberId<&KeyFrame::path>) ||
        (edited.member == memberId<&KeyFrame::path> && fits.error().where == "/value"))
        return {};
    return fail(fits.error().code, fits.error().message);
}

Result<void> checkTimeline(const Scene& scene) {
    for (std::size_t i = 0; i < scene.timeline.keys.size(); ++i)
        if (auto fits = checkKey(scene, scene.timeline.keys[i]); !fits)
            return fail(within(atPointer(fmt::format("/{}", i)), fits.error()));
    return checkTextures(scene);
}

Timeline fittingTimeline(const Scene& scene) {
    if (scene.timeline.keys.empty() || checkTimeline(scene))
        return scene.timeline;
    Scene tried = scene;
    std::erase_if(tried.timeline.keys, [&](const KeyFrame& key) { return !checkKey(scene, key); });
    if (!checkTextures(tried))
        std::erase_if(tried.timeline.keys,
                      [&](const KeyFrame& key) { return bindsTexture(scene, key.path); });
    return tried.timeline;
}

} // namespace texplorer

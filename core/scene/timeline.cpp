#include "texplorer/scene/timeline.h"

#include <algorithm>
#include <map>

namespace texplorer {

double eased(Easing easing, double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    switch (easing) {
    case Easing::Hold:
        return t < 1 ? 0 : 1;
    case Easing::Linear:
        return t;
    case Easing::EaseIn:
        return t * t;
    case Easing::EaseOut:
        return t * (2 - t);
    case Easing::EaseInOut:
        return t * t * (3 - 2 * t);
    }
    return t;
}

std::vector<Track> tracksOf(const Timeline& timeline) {
    std::vector<Track> tracks;
    std::map<std::string_view, std::size_t> known;
    for (const KeyFrame& key : timeline.keys) {
        const auto [at, isNew] = known.try_emplace(key.path, tracks.size());
        if (isNew)
            tracks.push_back({key.path, {}});
        tracks[at->second].keys.push_back(&key);
    }
    for (Track& track : tracks)
        std::ranges::stable_sort(track.keys, {}, &KeyFrame::time);
    return tracks;
}

Moment momentOf(const Track& track, double time) {
    const auto later =
        std::ranges::find_if(track.keys, [time](const KeyFrame* key) { return double{key->time} > time; });
    if (later == track.keys.begin())
        return {track.keys.front(), nullptr, 0};
    const KeyFrame* from = *(later - 1);
    if (later == track.keys.end())
        return {from, nullptr, 0};
    const double begin = double{from->time};
    return {from, *later, eased(from->easing, (time - begin) / (double{(*later)->time} - begin))};
}

double lengthOf(const Timeline& timeline) {
    double length = 0;
    for (const KeyFrame& key : timeline.keys)
        length = std::max(length, double{key.time});
    return length;
}

bool isMoving(const Timeline& timeline) {
    return std::ranges::any_of(tracksOf(timeline), [](const Track& track) {
        return std::ranges::any_of(track.keys, [&](const KeyFrame* key) {
            return key->value != track.keys.front()->value && key->time > 0;
        });
    });
}

} // namespace texplorer

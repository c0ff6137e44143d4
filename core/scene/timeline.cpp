#include "core/scene/timeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <optional>

namespace texplorer {
namespace {

/// "textures[12].wrapS" below "textures": 12 and ".wrapS".
struct ElementPath {
    std::size_t index;
    std::string_view rest;
};

std::optional<ElementPath> elementIn(std::string_view path, std::string_view list) {
    if (!path.starts_with(list) || path.size() <= list.size() || path[list.size()] != '[')
        return std::nullopt;
    path.remove_prefix(list.size() + 1);
    std::size_t index = 0;
    const char* end = path.data() + path.size();
    const auto [stop, error] = std::from_chars(path.data(), end, index);
    if (error != std::errc() || stop == end || *stop != ']')
        return std::nullopt;
    return ElementPath{index, path.substr(static_cast<std::size_t>(stop + 1 - path.data()))};
}

void renumber(Timeline& timeline, std::string_view list,
              const std::function<std::size_t(std::size_t index)>& number) {
    for (KeyFrame& key : timeline.keys)
        if (const auto element = elementIn(key.path, list)) {
            const std::size_t now = number(element->index);
            if (now != element->index) // what is written otherwise, "[01]", stays as it is where it may
                key.path = fmt::format("{}[{}]{}", list, now, element->rest);
        }
}

} // namespace

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

void elementRemoved(Timeline& timeline, std::string_view list, std::size_t index) {
    std::erase_if(timeline.keys, [&](const KeyFrame& key) {
        const auto element = elementIn(key.path, list);
        return element && element->index == index;
    });
    renumber(timeline, list, [index](std::size_t each) { return each > index ? each - 1 : each; });
}

void elementInserted(Timeline& timeline, std::string_view list, std::size_t index) {
    renumber(timeline, list, [index](std::size_t each) { return each >= index ? each + 1 : each; });
}

void elementsSwapped(Timeline& timeline, std::string_view list, std::size_t one, std::size_t other) {
    renumber(timeline, list, [one, other](std::size_t each) {
        return each == one ? other : each == other ? one : each;
    });
}

} // namespace texplorer

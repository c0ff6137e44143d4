#include "app/screenshot/shots/shot_list.h"

#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <unordered_map>

namespace texplorer::screenshot {
namespace {

constexpr const char* nameOption = "--out";
constexpr std::array<std::string_view, 5> fixedPlaces{"scene", "number", "renderer", "time", "size"};

/// Their product, or something above `max` where that is larger.
std::size_t boundedProduct(std::size_t a, std::size_t b, std::size_t max) {
    return b != 0 && a > max / b ? max + 1 : a * b;
}

bool standsFor(std::string_view place, const SweepAxis& axis) {
    return place == axis.path || place == keyOfPath(axis.path);
}

std::string inBraces(std::string_view place) {
    return fmt::format("{{{}}}", place);
}

} // namespace

std::size_t PictureKinds::count() const {
    return boundedProduct(boundedProduct(sizes.size(), times.size(), maxShots), renderers.size(), maxShots);
}

ShotList::ShotList(std::vector<Entry> entries, PictureKinds kinds)
    : entries_(std::move(entries))
    , kinds_(std::move(kinds)) {
    for (const Entry& entry : entries_) {
        std::size_t cases = kinds_.count();
        for (const SweepAxis& axis : entry.axes)
            cases = boundedProduct(cases, axis.values.size(), maxShots);
        count_ = std::min(count_ + cases, maxShots + 1);
        ends_.push_back(count_);
    }
}

ShotList::Case ShotList::at(std::size_t index) const {
    const auto end = std::ranges::upper_bound(ends_, index);
    Case shot;
    shot.entry = static_cast<std::size_t>(end - ends_.begin());
    std::size_t left = index - (shot.entry == 0 ? 0 : ends_[shot.entry - 1]);
    const auto next = [&left](std::size_t count) {
        const std::size_t digit = left % count;
        left /= count;
        return digit;
    };
    const std::vector<SweepAxis>& axes = entries_[shot.entry].axes;
    shot.values.resize(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;)
        shot.values[i] = next(axes[i].values.size());
    shot.time = kinds_.times[next(kinds_.times.size())];
    shot.size = kinds_.sizes[next(kinds_.sizes.size())];
    shot.renderer = kinds_.renderers[left];
    return shot;
}

Result<Scene> ShotList::sceneOf(const Case& shot) const {
    const Entry& entry = entryOf(shot);
    Scene scene = entry.opened.scene;
    for (std::size_t i = 0; i < entry.axes.size(); ++i) {
        const SweepAxis& axis = entry.axes[i];
        dropKeys(scene.timeline, axis.path); // they would have the last word
        if (const auto set = setParam(scene, axis.path, axis.values[shot.values[i]]); !set)
            return fail(set.error());
    }
    return scene;
}

Result<void> ShotList::checkPlaces(const NamePattern& pattern) const {
    static const std::vector<SweepAxis> none;
    const std::vector<SweepAxis>& axes = entries_.empty() ? none : entries_.front().axes;
    for (const std::string& place : pattern.places()) {
        std::vector<std::string_view> meant;
        for (const SweepAxis& axis : axes) {
            if (standsFor(place, axis))
                meant.push_back(axis.path);
        }
        const bool isFixed = std::ranges::find(fixedPlaces, place) != fixedPlaces.end();
        if (meant.size() > 1)
            return fail(ErrorCode::OutOfRange,
                        Sentence("{0} may be {1} or {2}: expected one of them as a whole", inBraces(place),
                                 meant[0], meant[1]),
                        atOption(nameOption));
        if (isFixed || meant.size() == 1)
            continue;
        std::string known;
        for (const std::string_view each : fixedPlaces)
            known.append(known.empty() ? "" : ", ").append(inBraces(each));
        for (const SweepAxis& axis : axes)
            known.append(", ").append(inBraces(keyOfPath(axis.path)));
        return fail(ErrorCode::OutOfRange, Sentence("expected one of {0}; found {1}", known, inBraces(place)),
                    atOption(nameOption));
    }
    return {};
}

Result<std::vector<std::string>> ShotList::names(const NamePattern& pattern) const {
    if (count_ > maxShots)
        return fail(ErrorCode::TooLarge,
                    Sentence("one call draws at most {0} pictures, expected fewer", maxShots));
    if (const Result<void> known = checkPlaces(pattern); !known)
        return fail(known.error());
    const std::size_t digits = std::to_string(count_).size();
    std::vector<std::string> names;
    std::unordered_map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < count_; ++i) {
        const Case shot = at(i);
        const Entry& entry = entryOf(shot);
        std::string name = pattern.fill([&](const std::string& place) {
            for (std::size_t axis = 0; axis < entry.axes.size(); ++axis) {
                if (standsFor(place, entry.axes[axis]))
                    return entry.axes[axis].values[shot.values[axis]];
            }
            if (place == "scene")
                return entry.name;
            if (place == "number")
                return fmt::format("{:0{}}", i + 1, digits);
            if (place == "renderer")
                return std::string(rowOf(shot.renderer).name);
            return place == "time" ? fmt::format("{}", shot.time)
                                   : fmt::format("{}x{}", shot.size.width, shot.size.height);
        });
        const auto [other, isNew] = numbers.try_emplace(name, i + 1);
        if (!isNew)
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected a name for each of {0} pictures, found \"{1}\" for number {2} "
                                 "and number {3}; {{number}} in it makes them different",
                                 count_, name, other->second, i + 1),
                        atOption(nameOption));
        names.push_back(std::move(name));
    }
    return names;
}

} // namespace texplorer::screenshot

#pragma once

// Key frames: which parameters of a scene move, and how. sceneAt (texplorer/scene/params/scene_at.h)
// evaluates them.

#include "texplorer/gl/enum_row.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

inline constexpr std::size_t maxKeyFrames = 1024;
inline constexpr float maxKeyTime = 3600; ///< seconds

/// How a parameter changes from a key to its next one. OpenGL has no names for these.
enum class Easing : std::uint32_t { Hold, Linear, EaseIn, EaseOut, EaseInOut };

inline constexpr std::array easingRows{
    row(Easing::Hold, "hold", "Hold", "Keeps the value until the next key."),
    row(Easing::Linear, "linear", "Linear", "Changes at constant speed."),
    row(Easing::EaseIn, "ease-in", "Ease in", "Starts slowly, with the square of the time."),
    row(Easing::EaseOut, "ease-out", "Ease out", "Ends slowly: ease in, backwards."),
    row(Easing::EaseInOut, "ease-in-out", "Ease in and out", "Starts slowly and ends slowly."),
};
static_assert(easingRows.size() == 5);

template<>
struct EnumTable<Easing> {
    static constexpr std::span<const EnumRow> rows = easingRows;
};

/// Maps a share of the time (0 to 1) to a share of the change: 0 to 0, 1 to 1, monotonic. EaseIn is t^2,
/// EaseOut 1 - (1 - t)^2, EaseInOut 3 t^2 - 2 t^3. Hold is 0 below 1.
[[nodiscard]] double eased(Easing easing, double share);

/// The value of a parameter at a time.
struct KeyFrame {
    float time = 0;                 ///< seconds
    std::string path{};             ///< of the parameter: "view.azimuth", "textures[0].wrapS"
    std::string value{};            ///< as for `texshot --set`: "45", "1,0,0,1", "GL_REPEAT"
    Easing easing = Easing::Linear; ///< to the parameter's next key

    bool operator==(const KeyFrame&) const = default;
};

/// All keys of a scene, in any order. If a parameter has several keys at one time, the last is used from then
/// on, and the first until then: a jump.
struct Timeline {
    std::vector<KeyFrame> keys{};

    bool operator==(const Timeline&) const = default;
};

/// The keys of one parameter, sorted by time; keys at the same time are in the scene's order.
struct Track {
    std::string_view path; ///< of the first key
    std::vector<const KeyFrame*> keys;
};

/// Returns one track for each parameter, in the order of their first keys. They point into the timeline.
[[nodiscard]] std::vector<Track> tracksOf(const Timeline& timeline);

/// The key before a time and the one after it (nullptr: none), with the eased share of the way between
/// them.
/// Before its first key, a parameter has that key's value; after the last one, the last one's. A track has at
/// least one key.
struct Moment {
    const KeyFrame* from;
    const KeyFrame* to;
    double share; ///< 0 to 1; 0 at a key
};
[[nodiscard]] Moment momentOf(const Track& track, double time);

/// The time of the last key; 0 if there is none.
[[nodiscard]] double lengthOf(const Timeline& timeline);

/// Whether any parameter has keys with different values.
[[nodiscard]] bool isMoving(const Timeline& timeline);

} // namespace texplorer

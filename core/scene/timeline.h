#pragma once

// Key frames: which parameters of a scene move, and how. What a scene looks like at a time is sceneAt's to
// say (core/scene/params/scene_at.h), which knows the parameters.

#include "core/gl/enum_row.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

inline constexpr std::size_t maxKeyFrames = 1024;
inline constexpr float maxKeyTime = 3600; ///< seconds

/// How a parameter goes from a key to the next one of the same parameter. OpenGL has no names for these.
enum class Easing : std::uint32_t { Hold, Linear, EaseIn, EaseOut, EaseInOut };

inline constexpr std::array easingRows{
    row(Easing::Hold, "hold", "Hold", "It stays what it is, and jumps when the next key comes."),
    row(Easing::Linear, "linear", "Linear", "It goes at the same speed all the way."),
    row(Easing::EaseIn, "ease-in", "Ease in", "It begins to move slowly, with the square of the time."),
    row(Easing::EaseOut, "ease-out", "Ease out", "It comes to rest slowly: ease in, backwards."),
    row(Easing::EaseInOut, "ease-in-out", "Ease in and out",
        "It begins slowly and comes to rest slowly, as a thing does that is pushed and stopped."),
};
static_assert(easingRows.size() == 5);

template<>
struct EnumTable<Easing> {
    static constexpr std::span<const EnumRow> rows = easingRows;
};

/// How much of the way is done after `share` (0 to 1) of the time: 0 at 0 and 1 at 1, never less than before.
/// EaseIn is t^2, EaseOut 1 - (1 - t)^2, EaseInOut 3 t^2 - 2 t^3. Hold has done nothing of it before 1.
[[nodiscard]] double eased(Easing easing, double share);

/// What a parameter is at a time.
struct KeyFrame {
    float time = 0;                 ///< seconds
    std::string path{};             ///< of the parameter: "view.azimuth", "textures[0].wrapS"
    std::string value{};            ///< as `texshot --set` has it: "45", "1,0,0,1", "GL_REPEAT"
    Easing easing = Easing::Linear; ///< from here to the parameter's next key

    bool operator==(const KeyFrame&) const = default;
};

/// All keys of a scene, in any order. Of those of one parameter at the same time the last one counts from
/// there on, the others until then: a jump.
struct Timeline {
    std::vector<KeyFrame> keys{};

    bool operator==(const Timeline&) const = default;
};

/// The keys of one parameter, by their time; those at the same time in the scene's order.
struct Track {
    std::string_view path; ///< of the first key
    std::vector<const KeyFrame*> keys;
};

/// One for each parameter, in the order of their first keys. They point into the timeline.
[[nodiscard]] std::vector<Track> tracksOf(const Timeline& timeline);

/// The key that holds at a time, and the one after it (nullptr: none), with how much of the way between them
/// is done. Before its first key a parameter is what that says, behind the last one what that says. A track
/// has at least one key.
struct Moment {
    const KeyFrame* from;
    const KeyFrame* to;
    double share; ///< 0 to 1; 0 at a key
};
[[nodiscard]] Moment momentOf(const Track& track, double time);

/// When the last key comes; 0 where there is none.
[[nodiscard]] double lengthOf(const Timeline& timeline);

/// Whether any parameter has keys that say different things.
[[nodiscard]] bool isMoving(const Timeline& timeline);

// Where an element is taken out of a list, comes in, or changes its place, its keys go with it: `list` is the
// path of the list, "models" or "passes[0].units[1].matrix".

/// Its keys go, and those behind it are of one less.
void elementRemoved(Timeline& timeline, std::string_view list, std::size_t index);

/// Those from `index` on are of one more.
void elementInserted(Timeline& timeline, std::string_view list, std::size_t index);

void elementsSwapped(Timeline& timeline, std::string_view list, std::size_t one, std::size_t other);

} // namespace texplorer

#pragma once

// What happens to a window, as values, in the order in which it happened. Every host makes them of what it is
// told.

#include "app/stage/surface.h"

#include <filesystem>
#include <variant>
#include <vector>

namespace texplorer::stage {

/// Which of these keys are held, on either side of the keyboard, once the event that names them has happened.
struct Modifiers {
    bool control = false;
    bool shift = false;
    bool alt = false;
    bool super = false;

    bool operator==(const Modifiers&) const = default;
};

/// In the units of Surface::size, from the top left.
struct PointerMoved {
    float x = 0;
    float y = 0;
};
/// Out of the window. While a button is held, what follows it goes on.
struct PointerLeft {};

struct ButtonChanged {
    int button = 0; ///< 0 left, 1 right, 2 middle, up to 4
    bool down = false;
    Modifiers modifiers{};
};

/// In notches: y above 0 away from the hand, x above 0 to the left.
struct WheelTurned {
    float x = 0;
    float y = 0;
    Modifiers modifiers{};
};

struct KeyChanged {
    enum class Kind { Press, Repeat, Release };
    Kind kind = Kind::Press;
    int code = 0; ///< as in app/ui/widgets/keys.h; others than these are ignored
    Modifiers modifiers{};
};

struct TextEntered {
    char32_t character = 0;
};

/// Of the keyboard.
struct FocusChanged {
    bool focused = false;
};

/// What the panels are told.
using Input = std::variant<PointerMoved, PointerLeft, ButtonChanged, WheelTurned, KeyChanged, TextEntered,
                           FocusChanged>;

struct SurfaceChanged {
    Surface surface;
};

struct FilesDropped {
    std::vector<std::filesystem::path> files;
};

/// The user wants to close the window.
struct CloseAsked {};

/// What is shown may be out of date: a worker has news, or the window was covered.
struct Refresh {};

using Event = std::variant<Input, SurfaceChanged, FilesDropped, CloseAsked, Refresh>;

} // namespace texplorer::stage

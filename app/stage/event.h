#pragma once

// Events of a window as values, in their order. Every host creates them from its own events.

#include "app/stage/file_requests.h"
#include "app/stage/surface.h"

#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

namespace texplorer::stage {

/// The modifier keys that are held, on either side of the keyboard, after the event.
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
/// The pointer has left the window. While a button is held, events of the pointer continue.
struct PointerLeft {};

struct ButtonChanged {
    int button = 0; ///< 0 left, 1 right, 2 middle, up to 4
    bool down = false;
    Modifiers modifiers{};
};

/// In notches: y above 0 is away from the user, x above 0 is to the left.
struct WheelTurned {
    float x = 0;
    float y = 0;
    Modifiers modifiers{};
};

struct KeyChanged {
    enum class Kind { Press, Repeat, Release };
    Kind kind = Kind::Press;
    int code = 0; ///< as in app/ui/widgets/keys.h; other keys are ignored
    Modifiers modifiers{};
};

struct TextEntered {
    char32_t character = 0;
};

/// The window got or lost the keyboard.
struct FocusChanged {
    bool focused = false;
};

/// The events that the panels receive.
using Input = std::variant<PointerMoved, PointerLeft, ButtonChanged, WheelTurned, KeyChanged, TextEntered,
                           FocusChanged>;

struct SurfaceChanged {
    Surface surface;
};

struct FilesDropped {
    std::vector<std::filesystem::path> files;
};

/// Files with their content, from a host without folders: the answer to a request, or dropped files.
struct FilesGiven {
    std::vector<NamedFile> files;
    std::optional<FileWish> answers{}; ///< nothing: the user has dropped them
};

/// The user wants to close the window.
struct CloseAsked {};

/// The window may be out of date: a worker has a result, or the window was covered.
struct Refresh {};

using Event = std::variant<Input, SurfaceChanged, FilesDropped, FilesGiven, CloseAsked, Refresh>;

} // namespace texplorer::stage

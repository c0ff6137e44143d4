#pragma once

#include "texplorer/scene/timeline.h"

#include <cstddef>
#include <string_view>

namespace texplorer::ui {

struct Session; // see session.h

// The key frames of a parameter replace its value. Panels show the scene at the present time, and edits start
// from it. An edit of a parameter with key frames, in any panel, sets a key at that time and stops the clock.

/// The time of a key that is set now: the present time, rounded to hundredths of a second.
[[nodiscard]] float presentKeyTime(const Session& session);
/// Sets the clock to this time and stops it.
void holdTime(Session& session);
void goToTime(Session& session, double seconds);
/// Goes to the next key of any parameter, or with -1 to the previous one.
void goToKey(Session& session, int direction);

// Each is an undo step. Errors are reported to the user.

/// Sets a key with the parameter's value at a time.
void addKey(const Session& session, std::string_view path, float time);
/// Sets two keys with which the view turns once around the models, and starts the clock at the first.
void turnView(Session& session);
void removeKey(const Session& session, std::size_t key);
/// Removes all keys of a parameter, which keeps its current value.
void removeKeys(const Session& session, std::string_view path);
/// Continues the same undo step until sealEdit. Returns true if the key has moved.
bool moveKey(const Session& session, std::size_t key, float time);
void setEasing(const Session& session, std::size_t key, Easing easing);

} // namespace texplorer::ui

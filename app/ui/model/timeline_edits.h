#pragma once

#include "core/scene/timeline.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer::ui {

struct Session; // see session.h

// A parameter that has key frames is nothing but them. While the panels are drawn, the document's scene is
// what it is at the present time, so that everything shows that and edits start from it; and an edit of such
// a parameter, wherever it is made, is a key at that time, and time stands still.

/// From here to endStanding the document's scene is that of the present time, with its timeline.
void beginStanding(Session& session);
/// What has keys is again what it was before. Nothing where it is that already: who puts another scene in the
/// document's place, or writes it, calls this first.
void endStanding(Session& session);

/// When an edit of now is a key: the present time, in hundredths of a second.
[[nodiscard]] float presentKeyTime(const Session& session);
/// The time is that, and stays.
void holdTime(Session& session);
void goToTime(Session& session, double seconds);
/// To the next key of any parameter, or with -1 to the one before.
void goToKey(Session& session, int direction);

// Each is a step of undo. What can't be is said to the user.

/// The parameter is at a time what it is then.
void addKey(Session& session, std::string_view path, float time);
/// Two keys with which the view turns once around the models, and time goes on from the first.
void turnView(Session& session);
void removeKey(Session& session, std::size_t key);
/// All of a parameter, which stays what it is now.
void removeKeys(Session& session, std::string_view path);
/// Goes on until sealEdit. True where it has moved.
bool moveKey(Session& session, std::size_t key, float time);
void setEasing(Session& session, std::size_t key, Easing easing);

} // namespace texplorer::ui

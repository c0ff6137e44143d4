#include "app/ui/model/playback.h"

#include "app/ui/model/preview.h"
#include "texplorer/scene/animation.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

bool isPlaying(const Session& session) {
    return session.look.playback.playing && session.look.playback.speed != 0 &&
           isAnimated(shownScene(session));
}

} // namespace

bool isMoving(const Session& session) {
    return isPlaying(session) || (session.lesson && session.lesson->holdsKey);
}

void advance(Session& session, double seconds) {
    if (!isPlaying(session))
        return;
    Playback& playback = session.look.playback;
    playback.time = std::max(0.0, playback.time + seconds * static_cast<double>(playback.speed));
    const double length = lengthOf(session.document.scene.timeline);
    if (playback.loops && length > 0 && playback.time > length)
        playback.time = std::fmod(playback.time, length);
}

} // namespace texplorer::ui

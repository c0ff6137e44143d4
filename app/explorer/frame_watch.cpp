#include "app/explorer/frame_watch.h"

#include "texplorer/base/clock.h"

#include <utility>

namespace texplorer::explorer {

FrameWatch::FrameWatch(Signals& signals, double limit)
    : signals_(signals)
    , limit_(limit) {
    signals_.onAlarm([this] { ring(); });
    begin();
}

FrameWatch::~FrameWatch() {
    end();
    signals_.onAlarm({});
}

void FrameWatch::whenHanging(std::function<void(double)> action) {
    const std::scoped_lock lock(mutex_);
    action_ = std::move(action);
}

void FrameWatch::begin() {
    watch(isFirst_ ? limit_ * firstFactor : limit_);
}

void FrameWatch::end() {
    watch(0);
}

void FrameWatch::drawn() {
    isFirst_ = false;
    end();
}

void FrameWatch::watch(double seconds) {
    const std::scoped_lock lock(mutex_);
    seconds_ = seconds;
    isSecond_ = false;
    due_ = steadySeconds() + seconds / 2;
    signals_.setAlarm(seconds / 2);
}

/// A process that was stopped for longer (SIGSTOP, a debugger) has the first alarm as soon as it continues:
/// only the second one, after another half, tells that the frame hangs.
void FrameWatch::ring() {
    const std::scoped_lock lock(mutex_);
    if (seconds_ <= 0)
        return;
    if (const double left = due_ - steadySeconds(); left > 0) // it was for a frame that has ended meanwhile
        return signals_.setAlarm(left);
    if (isSecond_) {
        if (action_)
            action_(seconds_);
        return;
    }
    isSecond_ = true;
    due_ = steadySeconds() + seconds_ / 2;
    signals_.setAlarm(seconds_ / 2);
}

} // namespace texplorer::explorer

#pragma once

#include "app/explorer/signals.h"

#include <functional>
#include <mutex>

namespace texplorer::explorer {

/// Notices that a frame takes far too long: the driver hangs, and the window's thread will not return. Uses
/// no processor time between frames.
class FrameWatch {
public:
    /// The default of `limit`.
    static constexpr double usualSeconds = 10;
    /// How much longer everything up to the first picture may take: drivers compile their shaders then.
    static constexpr double firstFactor = 6;

    /// How long a frame may take, in seconds; 0: any time. Watches from now on, as the first frame.
    FrameWatch(Signals& signals, double limit);
    FrameWatch(const FrameWatch&) = delete;
    FrameWatch& operator=(const FrameWatch&) = delete;
    ~FrameWatch();

    /// Sets the action, which runs on the thread of the signals with the limit of the frame that hangs. When
    /// this returns, the previous action is no longer running.
    void whenHanging(std::function<void(double seconds)> action);

    void begin(); ///< the next call that may hang
    void end();   ///< it has returned
    void drawn(); ///< the same, and there is a picture

private:
    void watch(double seconds);
    void ring();

    Signals& signals_;
    const double limit_;
    bool isFirst_ = true; ///< there was no picture yet
    std::mutex mutex_;    ///< protects what follows
    std::function<void(double)> action_;
    double seconds_ = 0; ///< of the present frame; 0: none is watched
    double due_ = 0;     ///< of the alarm, on the steady clock
    bool isSecond_ = false;
};

} // namespace texplorer::explorer

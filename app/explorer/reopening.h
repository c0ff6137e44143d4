#pragma once

#include "app/explorer/loop.h"
#include "app/stage/graphics.h"
#include "app/ui/model/session.h"

namespace texplorer::explorer {

/// What a window that starts again shows, and what it says about that. Call everything between two frames.
class Reopening {
public:
    Reopening(ui::Session& session, const stage::Graphics& graphics, const Beginning& beginning);

    /// Call once, after the files and the lesson were requested.
    void begin();
    /// Call with the events of the next frame.
    void receive(const std::vector<stage::Event>& events);
    /// What to show if the next frame hangs.
    [[nodiscard]] Restart::Reopened reopened() const;

private:
    [[nodiscard]] std::vector<std::string> shown() const;
    [[nodiscard]] bool driverDraws() const;
    void keepNotice();

    ui::Session& session_;
    const stage::Graphics& graphics_;
    const Beginning& beginning_;
    bool hasActed_ = false;     ///< the user has pressed something
    Sentence notice_;           ///< empty: none, or no longer needed
    std::size_t documents_ = 0; ///< as Session::documents when the notice was shown
};

} // namespace texplorer::explorer

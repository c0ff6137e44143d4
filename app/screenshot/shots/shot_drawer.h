#pragma once

#include "app/screenshot/gl/gl_module.h"

namespace texplorer::screenshot {

/// Draws one picture after the other, each by the renderer that its request names. With the first that needs
/// OpenGL a studio is opened, which stays: its shaders, pretence and context are those of that request. The
/// module that holds OpenGL is loaded for nothing else. Used on one thread.
class ShotDrawer {
public:
    /// Opens the studio where the request needs one: to know what is wrong before there is anything to draw.
    [[nodiscard]] Result<void> open(const ShotRequest& request);

    [[nodiscard]] Result<Shot> draw(const ShotRequest& request);

private:
    std::unique_ptr<Studio> studio_;
};

} // namespace texplorer::screenshot

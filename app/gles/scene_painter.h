#pragma once

#include "app/gles/device.h"
#include "app/view/frame.h"
#include "texplorer/base/result.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/texture_levels.h"

#include <memory>

namespace texplorer::gles {

/// Draws a Scene with shaders in GLSL ES 3.00 that sample textures themselves: as OpenGL 2.1 says, with 1D
/// textures, borders, GL_CLAMP, all formats and biases, which OpenGL ES lacks. Lines are one pixel wide.
class ScenePainter {
public:
    /// The device must outlive it. `work`: how textures are compressed at run time.
    explicit ScenePainter(Device& device, LevelWork work = {});
    ScenePainter(ScenePainter&&) noexcept;
    ScenePainter& operator=(ScenePainter&&) noexcept;
    ScenePainter(const ScenePainter&) = delete;
    ScenePainter& operator=(const ScenePainter&) = delete;
    ~ScenePainter();

    /// The picture is valid until the next call. Errors: OutOfRange for a size that the device can't draw,
    /// TooLarge without memory, Driver if it can't make the picture.
    [[nodiscard]] Result<view::Frame> draw(const Scene& scene, const ImageSource& images, double time,
                                           view::Size size);

    /// Call when the device has lost its objects: they are made again.
    void forgetObjects();

    /// The last picture: Rgba8, bottom row first. Error: NotFound if nothing was drawn.
    [[nodiscard]] Result<Image> read();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::gles

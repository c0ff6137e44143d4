#pragma once

#include "app/view/model_buffers.h"
#include "app/view/picture_handle.h"
#include "app/view/size.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace texplorer::gles {

/// The type of a uniform.
enum class UniformKind : std::uint8_t { Int, Float, Vec3, Vec4, Mat3, Mat4, Ivec4 };

/// What OpenGL ES 3.0 does for a ScenePainter. Names of objects are above 0; dropping a name that does not
/// exist has no effect.
class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual int maxTextureSize() const = 0;
    [[nodiscard]] virtual int maxPointSize() const = 0; ///< in pixels

    /// A texture that is read by texelFetch: `rows` rows of glsl::texelsPerRow texels of four bytes, or of
    /// four floats. 0: it could not be made.
    [[nodiscard]] virtual unsigned makeTexels(std::span<const std::byte> texels, int rows, bool floats) = 0;
    virtual void dropTexels(unsigned name) = 0;

    [[nodiscard]] virtual unsigned makeBuffer(view::BufferKind kind, std::span<const std::byte> content) = 0;
    virtual void dropBuffer(unsigned name) = 0;

    struct Compiled {
        unsigned program = 0; ///< 0: the sources are not accepted
        std::string log;      ///< why
    };
    [[nodiscard]] virtual Compiled makeProgram(std::string_view vertex, std::string_view fragment) = 0;
    virtual void dropProgram(unsigned name) = 0;

    /// A picture with 8 bits per component and at least 24 of depth, which panels can show. 0: it could not
    /// be made.
    [[nodiscard]] virtual unsigned makeTarget(view::Size size) = 0;
    virtual void dropTarget(unsigned name) = 0;
    [[nodiscard]] virtual view::PictureHandle pictureOf(unsigned target) const = 0;
    /// Rgba8, bottom row first, of the target's size.
    virtual void read(unsigned target, Image& image) = 0;

    /// Starts to draw into a target, which gets this colour and the depth 1.
    virtual void begin(unsigned target, view::Size size, const glm::vec4& background) = 0;
    /// Sets the depth test and blending of a pass.
    virtual void setFragmentTests(const Pass& pass) = 0;
    virtual void use(unsigned program) = 0;
    /// Sets a uniform of the program in use: `count` values, one after the other. A name that it does not
    /// have is ignored.
    virtual void setUniform(std::string_view name, UniformKind kind, const void* values, int count) = 0;
    virtual void setTexels(int unit, unsigned texels) = 0;
    /// Floats from a buffer, or the same four for all vertices. A stride of 0 means packed.
    virtual void setAttribute(unsigned location, unsigned buffer, int components, int stride,
                              std::size_t offset) = 0;
    virtual void setAttribute(unsigned location, const glm::vec4& value) = 0;
    /// Draws parts of `corners` vertices, by 32-bit indices from the `first` on.
    virtual void draw(int corners, unsigned indices, std::size_t first, std::size_t count) = 0;
    /// Ends what `begin` started.
    virtual void end() = 0;
};

} // namespace texplorer::gles

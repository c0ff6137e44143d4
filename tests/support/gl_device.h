#pragma once

#include "app/gles/device.h"
#include "app/render/state_guard.h"

#include <map>
#include <optional>

namespace texplorer::test {

/// A gles::Device on the current context, whose driver has GL_ARB_ES3_compatibility. Asserts what WebGL
/// refuses.
class GlDevice final : public gles::Device {
public:
    [[nodiscard]] int maxTextureSize() const override;
    [[nodiscard]] int maxPointSize() const override;
    [[nodiscard]] unsigned makeTexels(std::span<const std::byte> texels, int rows, bool floats) override;
    void dropTexels(unsigned name) override;
    [[nodiscard]] unsigned makeBuffer(view::BufferKind kind, std::span<const std::byte> content) override;
    void dropBuffer(unsigned name) override;
    [[nodiscard]] Compiled makeProgram(std::string_view vertex, std::string_view fragment) override;
    void dropProgram(unsigned name) override;
    [[nodiscard]] unsigned makeTarget(view::Size size) override;
    void dropTarget(unsigned name) override;
    [[nodiscard]] view::PictureHandle pictureOf(unsigned target) const override;
    void read(unsigned target, Image& image) override;
    void begin(unsigned target, view::Size size, const glm::vec4& background) override;
    void setFragmentTests(const Pass& pass) override;
    void use(unsigned program) override;
    void setUniform(std::string_view name, gles::UniformKind kind, const void* values, int count) override;
    void setTexels(int unit, unsigned texels) override;
    void setAttribute(unsigned location, unsigned buffer, int components, int stride,
                      std::size_t offset) override;
    void setAttribute(unsigned location, const glm::vec4& value) override;
    void draw(int corners, unsigned indices, std::size_t first, std::size_t count) override;
    void end() override;

    int programs = 0; ///< that exist

private:
    struct Target {
        unsigned color = 0;
        unsigned depth = 0;
    };

    std::map<unsigned, Target> targets_;   ///< by framebuffer
    std::map<unsigned, unsigned> enabled_; ///< buffers by attribute, which stay from one frame to the next
    unsigned program_ = 0;
    std::optional<render::StateGuard> guard_;
};

} // namespace texplorer::test

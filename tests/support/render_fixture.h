#pragma once

#include "app/offscreen/context.h"
#include "app/render/scene_renderer.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/renderer.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace texplorer::test {

/// Which renderer a RenderTest has: fixed function, unless the program was started with --renderer=shader.
/// Every test runs with both.
[[nodiscard]] RendererKind& testedRenderer();

/// The renderer that a RenderTest has, for other capabilities.
[[nodiscard]] Result<render::SceneRenderer> makeRenderer(const view::Capabilities& capabilities);

/// A context without a display and a renderer in it, new for every test.
class RenderTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Draws into a square of `extent` pixels and reads it back. What was wrong is in `problems`.
    [[nodiscard]] Image picture(const Scene& scene, int extent = 8, double time = 0);

    /// The colour of every pixel of a picture that has one colour, 0 to 1; a failure where it has several.
    [[nodiscard]] glm::vec4 onlyColor(const Scene& scene, int extent = 8, double time = 0);

    [[nodiscard]] reference::AnisotropyMethod anisotropy() const { ///< of the driver
        return reference::anisotropyMethodOf(capabilities.renderer, capabilities.version);
    }

    view::Capabilities capabilities;
    ImageSource images;
    std::vector<Sentence> problems;
    std::optional<render::SceneRenderer> renderer;

private:
    std::optional<offscreen::Context> context_;
};

/// The colour of one pixel, 0 to 1; (0, 0) is at the bottom left.
[[nodiscard]] glm::vec4 colorAt(const Image& image, int x, int y);

/// Equal within `steps` 255ths in every component.
[[nodiscard]] testing::AssertionResult isColor(glm::vec4 found, glm::vec4 expected, float steps = 1);

} // namespace texplorer::test

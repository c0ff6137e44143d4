#include "tests/support/render_fixture.h"

#include "app/render/shader_renderer.h"

#include <cmath>

namespace texplorer::test {

RendererKind& testedRenderer() {
    static RendererKind kind = RendererKind::Fixed;
    return kind;
}

Result<render::SceneRenderer> makeRenderer(const view::Capabilities& capabilities) {
    return render::createRenderer(testedRenderer(), capabilities);
}

void RenderTest::SetUp() {
    Result<offscreen::Context> context = offscreen::Context::create({1, 1});
    ASSERT_TRUE(context) << describe(context.error());
    context_ = std::move(*context);
    Result<view::Capabilities> loaded = render::loadCapabilities();
    ASSERT_TRUE(loaded) << describe(loaded.error());
    capabilities = *loaded;
    Result<render::SceneRenderer> made = makeRenderer(capabilities);
    ASSERT_TRUE(made) << describe(made.error());
    renderer = std::move(*made);
}

void RenderTest::TearDown() {
    renderer.reset(); // GL objects go before their context
    context_.reset();
}

Image RenderTest::picture(const Scene& scene, int extent, double time) {
    const Result<view::Frame> frame = renderer->draw(scene, images, time, {extent, extent});
    if (!frame) {
        ADD_FAILURE() << describe(frame.error());
        return {};
    }
    problems = frame->problems;
    Result<Image> image = renderer->read();
    if (!image) {
        ADD_FAILURE() << describe(image.error());
        return {};
    }
    return std::move(*image);
}

glm::vec4 RenderTest::onlyColor(const Scene& scene, int extent, double time) {
    const Image image = picture(scene, extent, time);
    if (image.empty())
        return {};
    const glm::vec4 first = colorAt(image, 0, 0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!isColor(colorAt(image, x, y), first, 0)) {
                ADD_FAILURE() << "pixel " << x << ", " << y << ": "
                              << isColor(colorAt(image, x, y), first, 0).message();
                return first;
            }
        }
    }
    return first;
}

glm::vec4 colorAt(const Image& image, int x, int y) {
    const ByteView bytes = image.at(x, y);
    glm::vec4 color;
    for (int i = 0; i < 4; ++i)
        color[i] = static_cast<float>(bytes[static_cast<std::size_t>(i)]) / 255.0F;
    return color;
}

testing::AssertionResult isColor(glm::vec4 found, glm::vec4 expected, float steps) {
    constexpr float rounding = 0.51F; // the picture's own eight bits
    for (int i = 0; i < 4; ++i) {
        if (!(std::abs(found[i] - expected[i]) * 255 <= steps + (steps > 0 ? rounding : 0)))
            return testing::AssertionFailure()
                   << "component "
                   << "rgba"[i] << " is " << found[i] * 255 << " instead of " << expected[i] * 255
                   << " (of 255); found (" << found.r << ", " << found.g << ", " << found.b << ", " << found.a
                   << "), expected (" << expected.r << ", " << expected.g << ", " << expected.b << ", "
                   << expected.a << ")";
    }
    return testing::AssertionSuccess();
}

} // namespace texplorer::test

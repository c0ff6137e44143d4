#include "app/render/fixed_renderer.h"

#include "app/render/fixed_state.h"
#include "app/render/pipeline.h"
#include "app/render/texture_stacks.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <string>

namespace texplorer::render {

namespace {

class FixedPipeline : public Pipeline {
public:
    explicit FixedPipeline(int textureUnits)
        : textureUnits_(textureUnits)
        , stacks_(textureUnits) {}

    [[nodiscard]] VertexInput vertexInput() const override { return VertexInput::FixedArrays; }

    void beginFrame(const Scene& scene, float aspect, GlErrors& errors) override {
        stacks_.beginFrame();
        applyProjection(scene.view, aspect);
        glLoadIdentity();
        applyLight(scene.light);
        errors.check("glLight");
        glShadeModel(static_cast<GLenum>(scene.material.shadeModel));
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, static_cast<GLenum>(scene.view.perspectiveHint));
        errors.check("glHint");
    }

    [[nodiscard]] bool beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures,
                                 double time, GlErrors& errors) override {
        applyFixedPass(scene.passes[pass]);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        for (int i = 0; i < maxUnits; ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (textures[at].name != 0)
                applyUnit(i, scene.passes[pass].units[at], textures[at]);
            else if (i < textureUnits_)
                switchUnitOff(i);
            errors.check([&] { return fmt::format("passes[{}].units[{}]: glTexEnv, glTexGen", pass, i); });
        }
        stacks_.beginPass(scene, pass, textures, time);
        errors.check([&] { return fmt::format("passes[{}]: glPushMatrix", pass); });
        return true;
    }

    void beginModel(const Scene& scene, std::size_t pass, std::size_t model, bool /*colored*/,
                    double time) override {
        applyMaterial(materialOf(scene, scene.models[model])); // a mesh with colours has overwritten glColor
        stacks_.beginModel(scene, pass, model, time);
        applyModelView(scene.view, scene.models[model], time);
    }

    void endModel() override { stacks_.endModel(); }
    void endPass() override { stacks_.endPass(); }

private:
    int textureUnits_;
    TextureStacks stacks_;
};

} // namespace

Result<FixedRenderer> FixedRenderer::create(const view::Capabilities& capabilities) {
    return FixedRenderer(capabilities, std::make_unique<FixedPipeline>(capabilities.textureUnits));
}

} // namespace texplorer::render

#include "app/render/shader_renderer.h"

#include "app/render/fixed_renderer.h"
#include "app/render/pipeline.h"
#include "app/render/shader_folder.h"
#include "app/render/shader_program.h"
#include "app/view/shader_uniforms.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace texplorer::render {

namespace {

/// Programs are few: a scene has at most eight passes. More than these come from edited shaders.
constexpr std::size_t maxPrograms = 256;

glsl::SampledUnits sampledUnits(const BoundTextures& textures) {
    glsl::SampledUnits units;
    std::ranges::transform(textures, units.begin(), [](const BoundTexture& texture) {
        return texture.name != 0
                   ? std::optional(glsl::SampledUnit{texture.format, texture.lateFlip, texture.isUnclamped,
                                                     texture.hasDepths, texture.compares})
                   : std::nullopt;
    });
    return units;
}

class ShaderPipeline : public Pipeline {
public:
    explicit ShaderPipeline(const ShaderOptions& options) {
        if (!options.folder.empty())
            folder_.emplace(options.folder, options.wake);
    }

    [[nodiscard]] VertexInput vertexInput() const override { return VertexInput::Attributes; }

    void beginFrame(const Scene& scene, float aspect, GlErrors& errors) override {
        projection_ = projectionMatrix(scene.view, aspect);
        shaders_.resize(scene.passes.size());
        if (programs_.size() > maxPrograms)
            programs_.clear();
        if (!folder_)
            return;
        if (folder_->refresh()) {
            newest_ = std::make_shared<const glsl::ShaderPieces>(*folder_->pieces());
            ++revision_;
        }
        if (!folder_->problem().empty())
            errors.add(newest_ ? Sentence("{0}; the last readable shaders stay", folder_->problem())
                               : Sentence("{0}; drawn with Texplorer's own shaders", folder_->problem()));
    }

    [[nodiscard]] bool beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures,
                                 double /*time*/, GlErrors& errors) override {
        const std::string where = fmt::format("passes[{}]", pass);
        units_ = sampledUnits(textures);
        program_ = programOf(scene, pass, units_, where, errors);
        if (!program_)
            return false;
        program_->use();
        view::setPass(*program_, scene, scene.passes[pass]);
        for (int i = 0; i < maxUnits; ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (!units_[at])
                continue;
            const Unit& unit = scene.passes[pass].units[at];
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
            const auto target = static_cast<GLenum>(unit.target);
            glBindTexture(target, textures[at].name);
            // As core profiles, for which the shader is written, have it; NVIDIA applies GL_ALPHA to shadow
            // samplers.
            if (textures[at].hasDepths)
                glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
            glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0); // it is added to that of the shader
            program_->set(fmt::format("texture{}", i), i);
            program_->set(fmt::format("lodBias{}", i), unitBias(unit, textures[at]));
            view::setUnit(*program_, at, unit);
        }
        errors.check([&] { return fmt::format("{}: glUniform", where); });
        return true;
    }

    [[nodiscard]] std::vector<std::shared_ptr<const view::PassShader>> shaders() const override {
        return shaders_;
    }

    [[nodiscard]] std::uint64_t revision() const override { return revision_; }

    void beginModel(const Scene& scene, std::size_t pass, std::size_t modelIndex, bool colored,
                    double time) override {
        if (!colored)
            glVertexAttrib4fv(glsl::colorAttribute,
                              glm::value_ptr(materialOf(scene, scene.models[modelIndex]).color));
        view::setModel(*program_, scene, pass, modelIndex, projection_, units_, time);
    }

private:
    struct Compiled {
        tl::expected<ShaderProgram, ShaderProgram::Log> program = tl::unexpected(ShaderProgram::Log{});
        std::shared_ptr<const view::PassShader> shader;
    };

    /// Uses the newest pieces; if they do not compile, the last ones that did, or the embedded ones. Errors
    /// of the newest are reported in `errors` and with their source.
    const ShaderProgram* programOf(const Scene& scene, std::size_t pass, const glsl::SampledUnits& units,
                                   const std::string& where, GlErrors& errors) {
        ShaderProgram::Log log;
        if (folder_ && !folder_->problem().empty())
            log.push_back({std::nullopt, 0, folder_->problem()});
        std::shared_ptr<const view::PassShader>& shown = shaders_[pass];
        shown = nullptr;
        const ShaderProgram* program = nullptr;
        for (const glsl::ShaderPieces* pieces : candidates()) {
            const Result<glsl::ShaderSource> source = glsl::shaderSource(scene, pass, units, *pieces);
            const Compiled* made = source ? &compiled(*source) : nullptr;
            program = made && made->program ? &*made->program : nullptr;
            if (made && !shown)
                shown = made->shader;
            if (program) {
                if (pieces == newest_.get())
                    good_ = newest_;
                break;
            }
            const ShaderProgram::Log found =
                made ? made->program.error()
                     : ShaderProgram::Log{{std::nullopt, 0, describe(source.error())}};
            if (log.empty())
                log = found;
            for (const view::ShaderMessage& message : found)
                errors.add(Sentence("{0}: {1}", ProperName{where}, message.sentence));
        }
        if (shown && shown->log != log)
            shown = std::make_shared<const view::PassShader>(view::PassShader{shown->source, std::move(log)});
        return program;
    }

    [[nodiscard]] std::vector<const glsl::ShaderPieces*> candidates() const {
        std::vector<const glsl::ShaderPieces*> pieces;
        if (newest_)
            pieces.push_back(newest_.get());
        if (good_ && good_ != newest_)
            pieces.push_back(good_.get());
        pieces.push_back(&glsl::ShaderPieces::embedded());
        return pieces;
    }

    const Compiled& compiled(const glsl::ShaderSource& source) {
        const auto [found, isNew] = programs_.try_emplace({source.vertex.text, source.fragment.text});
        if (isNew) {
            found->second.program = ShaderProgram::compile(source);
            found->second.shader = std::make_shared<const view::PassShader>(view::PassShader{
                source, found->second.program ? ShaderProgram::Log{} : found->second.program.error()});
        }
        return found->second;
    }

    std::map<std::pair<std::string, std::string>, Compiled> programs_; // keyed by their two sources
    const ShaderProgram* program_ = nullptr;                           // of the current pass
    glsl::SampledUnits units_;                                         // of the current pass
    glm::mat4 projection_{1};
    std::vector<std::shared_ptr<const view::PassShader>> shaders_; // of the last drawing of each pass
    std::uint64_t revision_ = 0;                                   // of the pieces in use
    std::optional<ShaderFolder> folder_;
    std::shared_ptr<const glsl::ShaderPieces> newest_; // of the folder
    std::shared_ptr<const glsl::ShaderPieces> good_;   // the last ones of the folder that compiled
};

} // namespace

Result<ShaderRenderer> ShaderRenderer::create(const view::Capabilities& capabilities,
                                              const ShaderOptions& options) {
    const view::OfferedRenderers offered = offeredRenderers(capabilities);
    if (!offered.has(RendererKind::Shader))
        return fail(ErrorCode::Unsupported, offered.whyNot(RendererKind::Shader));
    return ShaderRenderer(capabilities, std::make_unique<ShaderPipeline>(options));
}

view::OfferedRenderers offeredRenderers(const view::Capabilities& capabilities) {
    view::OfferedRenderers offered;
    if (!capabilities.shaders)
        offered.withhold(
            RendererKind::Shader,
            GLEW_VERSION_3_3
                ? N_("the shader renderer needs OpenGL 3.3 with GLSL 3.30, which --pretend disables")
                : Sentence("the shader renderer needs OpenGL 3.3 with GLSL 3.30, the driver has OpenGL {0}",
                           ProperName{capabilities.version}));
    return offered;
}

Result<SceneRenderer> createRenderer(RendererKind kind, const view::Capabilities& capabilities,
                                     const ShaderOptions& options) {
    const auto asSceneRenderer = [](SceneRenderer&& made) { return SceneRenderer(std::move(made)); };
    switch (kind) {
    case RendererKind::Fixed:
        return FixedRenderer::create(capabilities).map(asSceneRenderer);
    case RendererKind::Shader:
        return ShaderRenderer::create(capabilities, options).map(asSceneRenderer);
    case RendererKind::Reference:
        return fail(ErrorCode::Unsupported, "the reference draws without OpenGL");
    }
    return fail(ErrorCode::OutOfRange, "there is no such renderer");
}

} // namespace texplorer::render

#include "app/render/scene_renderer.h"

#include "app/render/fragment_state.h"
#include "app/render/gl_errors.h"
#include "app/render/mesh_cache.h"
#include "app/render/pipeline.h"
#include "app/render/render_target.h"
#include "app/render/state_guard.h"
#include "app/render/texture_cache.h"
#include "texplorer/base/sentence.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/scene_at.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <new>
#include <optional>
#include <set>

namespace texplorer::render {

namespace {

/// The driver's own limit, regardless of a pretended limit for textures.
view::Size maxPictureSize() {
    std::array<GLint, 2> viewport{};
    GLint renderbuffer = 0;
    GLint texture = 0;
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    const int limit = std::min(renderbuffer, texture);
    return {std::min(limit, viewport[0]), std::min(limit, viewport[1])};
}

CoordUse coordUseOf(const BoundTexture& texture) {
    if (texture.name == 0)
        return CoordUse::Off;
    return texture.lateFlip == LateFlip::Coordinates ? CoordUse::Flipped : CoordUse::AsGiven;
}

Result<Image> readPixels(const RenderTarget& target) {
    const view::Size size = target.size();
    Image image;
    try {
        image = Image::uninitialised(PixelFormat::Rgba8, size.width, size.height);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    Sentence("not enough memory for a picture of {0} pixels", asText(size)));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    if (GlErrors errors; !errors.check("glReadPixels"))
        return fail(ErrorCode::Driver, errors.sentences().front());
    return image;
}

} // namespace

struct SceneRenderer::State {
    State(const view::Capabilities& given, std::unique_ptr<Pipeline> chosen)
        : capabilities(given)
        , pipeline(std::move(chosen))
        , limit(maxPictureSize())
        , textures(std::make_shared<TextureCache>(given))
        , meshes(pipeline->vertexInput()) {}

    void drawScene(const Scene& scene, const ImageSource& images, double time, view::Size size);
    void drawMissingShaders(const Scene& scene, const ImageSource& images, double time);
    void applySeamlessCubeMap(const Pass& pass, const std::string& where);
    BoundTextures texturesOf(const TextureUse& frame, std::size_t passIndex, const ImageSource& images);
    BoundTexture textureOf(const TextureUse& frame, const Unit& unit, int unitIndex, const std::string& where,
                           const ImageSource& images);
    void remember(const Scene& scene, double time, view::Size size);

    /// The inputs of a picture.
    struct Drawn {
        Scene scene;
        double time = 0;
        view::Size size;
        std::uint64_t textures = 0;
        std::uint64_t pipeline = 0;
    };

    view::Capabilities capabilities;
    std::unique_ptr<Pipeline> pipeline;
    view::Size limit;
    RenderTarget target;
    RenderTarget pictures; ///< that textures show
    std::shared_ptr<TextureCache> textures;
    MeshCache meshes;
    std::optional<Drawn> drawn;
    std::uint64_t revision = 0;
    LevelsSource* levels = nullptr;    // of the current frame
    GlErrors errors;                   // of the current frame
    std::set<std::size_t> drawnPasses; // in the current frame
};

SceneRenderer::SceneRenderer(const view::Capabilities& capabilities, std::unique_ptr<Pipeline> pipeline)
    : state_(std::make_unique<State>(capabilities, std::move(pipeline))) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<view::Frame> SceneRenderer::draw(const Scene& scene, const ImageSource& images, double time,
                                        view::Size size, LevelsSource* levels) {
    State& state = *state_;
    if (size.width < 1 || size.height < 1 || size.width > state.limit.width ||
        size.height > state.limit.height)
        return fail(ErrorCode::OutOfRange, Sentence("a picture has 1 × 1 to {0} pixels, not {1}",
                                                    asText(state.limit), asText(size)));
    const auto begin = std::chrono::steady_clock::now();
    view::Frame frame{.size = size};
    state.errors = {};
    state.drawnPasses.clear();
    state.levels = levels;
    state.errors.check(N_("before the scene was drawn")); // caused by other code, but not yet reported
    try {
        const StateGuard guard;
        state.errors.check("glPushAttrib");
        const StandingScene standing(scene, time);
        state.meshes.beginFrame();
        const auto drawPicture = [&state](const Scene& picture, const ImageSource& known, double then,
                                          int extent) -> Result<Image> {
            const view::Size square{extent, extent};
            if (const Result<void> bound = state.pictures.bind(square); !bound)
                return fail(bound.error());
            state.drawScene(picture, known, then, square);
            return readPixels(state.pictures);
        };
        const std::uint64_t before = state.textures->revision();
        Result<ImageSource> all = state.textures->withDrawn(images, *standing, scene, time, drawPicture);
        if (!all)
            return fail(all.error());
        if (const Result<void> bound = state.target.bind(size); !bound)
            return fail(bound.error());
        if (hasPictures(*standing))
            state.drawScene(picturedScene(*standing, 0), *all, time, size);
        else // without a copy
            state.drawScene(*standing, *all, time, size);
        state.remember(*standing, time, size);
        frame.pictures = all->pictures();
        // Pictures may show textures as they were before this frame.
        frame.unfinished = !frame.pictures.empty() && state.textures->revision() != before;
        state.drawMissingShaders(*standing, *all, time);
        frame.shaders = state.pipeline->shaders();
        for (std::size_t i = 0; i < frame.shaders.size(); ++i) {
            if (!standing->passes[i].enabled)
                frame.shaders[i] = nullptr;
        }
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for the scene's images and meshes");
    }
    state.errors.check("glPopAttrib");
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    frame.picture = handleOf(state.target.texture());
    frame.milliseconds = elapsed.count();
    frame.problems = state.errors.sentences();
    frame.unfinished |= state.textures->isUploading();
    frame.stored = state.textures->stored();
    frame.revision = state.revision;
    return frame;
}

void SceneRenderer::State::drawScene(const Scene& scene, const ImageSource& images, double time,
                                     view::Size size) {
    glViewport(0, 0, size.width, size.height);
    const glm::vec4& background = scene.view.background;
    glClearColor(background.r, background.g, background.b, background.a);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    errors.check("glClear");

    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    pipeline->beginFrame(scene, aspect, errors);
    textures->keepOnly(scene);
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        if (!scene.passes[i].enabled)
            continue;
        drawnPasses.insert(i);
        const std::string where = fmt::format("passes[{}]", i);
        applyDepthAndBlend(scene.passes[i]);
        errors.check([&] { return fmt::format("{}: glDepthFunc, glBlendFunc", where); });
        applySeamlessCubeMap(scene.passes[i], where);
        const BoundTextures bound = texturesOf({scene, 0, time, size.width, size.height}, i, images);
        if (!pipeline->beginPass(scene, i, bound, time, errors))
            continue;
        std::array<CoordUse, maxUnits> uses{};
        std::ranges::transform(bound, uses.begin(), coordUseOf);
        for (const std::size_t m : drawnModels(scene, scene.passes[i])) {
            const Model& model = scene.models[m];
            meshes.bind(scene, scene.passes[i], m, time, uses);
            applyLineAndPoint(model);
            pipeline->beginModel(scene, i, m, meshes.hasColors(), time);
            errors.check([&] { return fmt::format("models[{}]: glMaterial, glLineWidth, glPointSize", m); });
            meshes.draw();
            pipeline->endModel();
        }
        pipeline->endPass();
        errors.check([&] { return fmt::format("{}: glDrawRangeElements", where); });
    }
}

/// Pictures that another renderer has drawn need shaders too, for those who read them: they are drawn as one
/// pixel.
void SceneRenderer::State::drawMissingShaders(const Scene& scene, const ImageSource& images, double time) {
    const std::vector<std::shared_ptr<const view::PassShader>> shaders = pipeline->shaders();
    std::set<int> missing;
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        if (scene.passes[i].enabled && !drawnPasses.contains(i))
            missing.insert(scene.passes[i].picture);
    }
    for (const int picture : missing) {
        if (!pictures.bind(pictures.size() == view::Size{} ? view::Size{1, 1} : pictures.size()))
            return;
        drawScene(picturedScene(scene, picture), images, time, {1, 1});
    }
    drawnPasses.clear();
}

/// Reports nothing for a pass without cube maps: it does not matter there.
void SceneRenderer::State::applySeamlessCubeMap(const Pass& pass, const std::string& where) {
    if (capabilities.seamlessCubeMaps)
        return (pass.seamlessCubeMap ? glEnable : glDisable)(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    const bool matters = std::ranges::any_of(
        pass.units, [](const Unit& unit) { return unit.enabled && unit.target == Target::CubeMap; });
    if (pass.seamlessCubeMap && matters)
        errors.add(Sentence("{0}: the driver has no seamless cube maps; drawn without", ProperName{where}));
}

void SceneRenderer::State::remember(const Scene& scene, double time, view::Size size) {
    if (drawn && drawn->scene == scene && drawn->time == time && drawn->size == size &&
        drawn->textures == textures->revision() && drawn->pipeline == pipeline->revision())
        return;
    drawn = {scene, time, size, textures->revision(), pipeline->revision()};
    ++revision;
}

/// Ignores the texture of `frame`: each unit has its own.
BoundTextures SceneRenderer::State::texturesOf(const TextureUse& frame, std::size_t passIndex,
                                               const ImageSource& images) {
    BoundTextures bound{};
    for (int i = 0; i < maxUnits; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Unit& unit = frame.scene.passes[passIndex].units[at];
        if (unit.enabled)
            bound[at] = textureOf(frame, unit, i, fmt::format("passes[{}].units[{}]", passIndex, i), images);
    }
    return bound;
}

BoundTexture SceneRenderer::State::textureOf(const TextureUse& frame, const Unit& unit, int unitIndex,
                                             const std::string& where, const ImageSource& images) {
    const std::size_t count = frame.scene.textures.size();
    if (unitIndex >= capabilities.textureUnits) {
        errors.add(
            Sentence("{0}: the driver has {1}; drawn without this one", ProperName{where},
                     Sentence::plural("{0} texture unit", "{0} texture units", capabilities.textureUnits)));
        return {};
    }
    if (unit.texture < 0 || static_cast<std::size_t>(unit.texture) >= count) {
        errors.add(Sentence("{0}: there is no texture {1}, the scene has {2}; drawn without it",
                            ProperName{where}, unit.texture, count));
        return {};
    }
    // Preparing a texture binds it: do it on its own unit, or it would replace another texture.
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unitIndex));
    const TextureUse use{frame.scene, static_cast<std::size_t>(unit.texture), frame.time, frame.width,
                         frame.height};
    return textures->prepare(use, unit.target, images, levels, errors);
}

void SceneRenderer::shareTextures(const SceneRenderer& other) {
    state_->textures = other.state_->textures;
}

Result<std::vector<TextureLevel>> SceneRenderer::readTexture(std::size_t index, Target target) {
    const TextureObject* object = state_->textures->find(index, target);
    if (!object)
        return fail(ErrorCode::NotFound, Sentence("it has not been drawn as {0}", rowOf(target).name),
                    fmt::format("textures[{}]", index));
    try {
        const StateGuard guard;
        static_cast<void>(GlErrors().check(N_("before the texture was read")));
        return object->read();
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for the levels of the texture");
    }
}

Result<Image> SceneRenderer::read() {
    State& state = *state_;
    if (state.target.size() == view::Size{})
        return fail(ErrorCode::NotFound, "there is no picture to read: nothing has been drawn yet");
    const StateGuard guard;
    static_cast<void>(
        GlErrors().check(N_("before the picture was read"))); // older errors do not belong to this call
    return readPixels(state.target);
}

} // namespace texplorer::render

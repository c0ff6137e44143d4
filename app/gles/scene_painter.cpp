#include "app/gles/scene_painter.h"

#include "app/gles/object.h"
#include "app/gles/texture_lists.h"
#include "app/view/shader_uniforms.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/glsl/shader_source.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/reference/drawn_pictures.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::gles {

namespace {

/// The uniforms of the program in use.
class Uniforms {
public:
    explicit Uniforms(Device& device)
        : device_(device) {}

    void set(std::string_view name, int value) const { send(name, UniformKind::Int, &value); }
    void set(std::string_view name, float value) const { send(name, UniformKind::Float, &value); }
    void set(std::string_view name, const glm::vec3& value) const { send(name, UniformKind::Vec3, &value); }
    void set(std::string_view name, const glm::vec4& value) const { send(name, UniformKind::Vec4, &value); }
    void set(std::string_view name, const glm::mat3& value) const { send(name, UniformKind::Mat3, &value); }
    void set(std::string_view name, const glm::mat4& value) const { send(name, UniformKind::Mat4, &value); }
    void set(std::string_view name, const std::vector<glm::ivec4>& values) const {
        device_.setUniform(name, UniformKind::Ivec4, values.data(), static_cast<int>(values.size()));
    }

private:
    void send(std::string_view name, UniformKind kind, const void* value) const {
        device_.setUniform(name, kind, value, 1);
    }

    Device& device_;
};

using BoundTextures = std::array<BoundTexture, maxUnits>;

glsl::SampledUnit sampledUnit(const BoundTexture& bound, const Pass& pass) {
    const reference::SampledTexture& texture = bound.stored->sampled;
    const bool hasDepths = isDepth(texture.internalFormat);
    const reference::Level* base = texture.level(texture.baseLevel);
    return {texture.format,
            bound.stored->lateFlip,
            bound.listed->isUnclamped,
            hasDepths,
            hasDepths && texture.compareMode == CompareMode::RToTexture,
            {},
            glsl::WrittenSampler{{texture.wrapS, texture.wrapT, texture.wrapR},
                                 texture.magFilter,
                                 texture.minFilter,
                                 std::floor(texture.maxAnisotropy) > 1,
                                 base && base->border > 0,
                                 texture.target == Target::CubeMap && pass.seamlessCubeMap,
                                 texture.compareFunc}};
}

glsl::SampledUnits sampledUnits(const BoundTextures& bound, const Pass& pass) {
    glsl::SampledUnits units;
    std::ranges::transform(bound, units.begin(), [&pass](const BoundTexture& texture) {
        return texture.stored ? std::optional(sampledUnit(texture, pass)) : std::nullopt;
    });
    return units;
}

/// Draws into a target until it is destroyed.
class Drawing {
public:
    Drawing(Device& device, unsigned target, view::Size size, const glm::vec4& background)
        : device_(device) {
        device.begin(target, size, background);
    }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;
    ~Drawing() { device_.end(); }

private:
    Device& device_;
};

/// The levels that minification uses, from the base level on.
std::vector<glm::ivec4> listedLevels(const ListedTexture& listed, const reference::SampledTexture& texture,
                                     int last) {
    std::vector<glm::ivec4> levels;
    for (int number = texture.baseLevel; number <= last && std::cmp_less(number, listed.levels.size()) &&
                                         levels.size() < glsl::maxListedLevels;
         ++number)
        levels.push_back(listed.levels[static_cast<std::size_t>(number)].value_or(glm::ivec4(1, 1, 1, 0)));
    return levels;
}

void setSampler(const Uniforms& uniforms, int index, const BoundTexture& bound, const Unit& unit) {
    const reference::SampledTexture& texture = bound.stored->sampled;
    const bool hasLevels = reference::wantsMipmaps(texture.minFilter);
    const int last = hasLevels ? reference::lastMipLevel(texture) : texture.baseLevel;
    const auto name = [index](const char* uniform) { return fmt::format("{}{}", uniform, index); };
    reference::SampleOptions options;
    options.unitBias = unit.lodBias;
    uniforms.set(name("texels"), index);
    uniforms.set(name("levels"), listedLevels(*bound.listed, texture, last));
    uniforms.set(name("borderColor"), texture.borderColor);
    uniforms.set(name("lod"),
                 glm::vec3(reference::lodBias(texture, options), texture.minLod, texture.maxLod));
    uniforms.set(name("lastLevel"), static_cast<float>(last - texture.baseLevel));
    uniforms.set(name("anisotropy"), std::min(std::floor(texture.maxAnisotropy), 1024.0F));
}

} // namespace

struct ScenePainter::State {
    State(Device& given, LevelWork work)
        : device(given)
        , buffers([this](view::BufferKind kind, std::span<const std::byte> content) {
            return own(device, device.makeBuffer(kind, content), &Device::dropBuffer);
        })
        , textures(given, std::move(work)) {}

    struct Surface {
        view::Size size;
        Object object;
    };
    struct Compiled {
        Object program; ///< nullptr: it does not compile
        std::shared_ptr<const view::PassShader> shader;
    };
    /// What a frame depends on.
    struct Drawn {
        Scene scene;
        ImageSource images;
        double time = 0;
        view::Size size;
    };

    Result<void> drawScene(Surface& into, const Scene& scene, const ImageSource& images, double time,
                           view::Size size);
    void drawPass(const Scene& scene, std::size_t pass, const BoundTextures& bound,
                  const glm::mat4& projection, double time);
    void drawModel(const Scene& scene, const Pass& pass, std::size_t model, double time,
                   const std::array<view::CoordUse, maxUnits>& uses);
    Result<view::Frame> drawFrame(const Scene& scene, const Scene& standing, const ImageSource& images,
                                  double time, view::Size size);
    BoundTextures texturesOf(const Scene& scene, std::size_t pass, const ImageSource& images);
    const Compiled* compiled(const Scene& scene, std::size_t pass, const BoundTextures& bound);
    void report(Sentence sentence);

    Device& device;
    view::ModelBuffers buffers;
    Surface target;
    Surface pictures; ///< that textures show
    TextureLists textures;
    reference::LightDepths lightDepths;
    reference::DrawnPictures drawnPictures;
    std::map<std::pair<std::string, std::string>, Compiled> programs; ///< by their two sources
    std::vector<std::shared_ptr<const view::PassShader>> shaders;     ///< of the current frame, by pass
    std::vector<Sentence> problems;                                   ///< of the current frame
    std::optional<Drawn> drawn;                                       ///< the last frame's inputs
    view::Frame frame;                                                ///< the last one
};

ScenePainter::ScenePainter(Device& device, LevelWork work)
    : state_(std::make_unique<State>(device, std::move(work))) {}
ScenePainter::ScenePainter(ScenePainter&&) noexcept = default;
ScenePainter& ScenePainter::operator=(ScenePainter&&) noexcept = default;
ScenePainter::~ScenePainter() = default;

Result<view::Frame> ScenePainter::draw(const Scene& scene, const ImageSource& images, double time,
                                       view::Size size) {
    State& state = *state_;
    const int limit = state.device.maxTextureSize();
    if (size.width < 1 || size.height < 1 || size.width > limit || size.height > limit)
        return fail(ErrorCode::OutOfRange, Sentence("a picture has 1 × 1 to {0} pixels, not {1}",
                                                    view::asText({limit, limit}), asText(size)));
    if (const auto& drawn = state.drawn; drawn && drawn->size == size && drawn->time == time &&
                                         drawn->images == images && drawn->scene == scene)
        return state.frame;
    state.drawn.reset();
    const auto begin = std::chrono::steady_clock::now();
    try {
        const StandingScene standing(scene, time);
        Result<view::Frame> frame = state.drawFrame(scene, *standing, images, time, size);
        if (!frame)
            return frame;
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
        frame->milliseconds = elapsed.count();
        frame->revision = state.frame.revision + 1;
        state.frame = *std::move(frame);
        state.drawn = {scene, images, time, size};
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for the scene's images and meshes");
    }
    return state.frame;
}

void ScenePainter::forgetObjects() {
    const std::uint64_t revision = state_->frame.revision;
    state_ = std::make_unique<State>(state_->device, state_->textures.work());
    state_->frame.revision = revision;
}

Result<Image> ScenePainter::read() {
    State& state = *state_;
    if (!state.target.object)
        return fail(ErrorCode::NotFound, "there is no picture to read: nothing has been drawn yet");
    const view::Size size = state.target.size;
    try {
        Image image = Image::uninitialised(PixelFormat::Rgba8, size.width, size.height);
        state.device.read(*state.target.object, image);
        return image;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    Sentence("not enough memory for a picture of {0} pixels", asText(size)));
    }
}

/// `standing` is the scene at that time.
Result<view::Frame> ScenePainter::State::drawFrame(const Scene& scene, const Scene& standing,
                                                   const ImageSource& images, double time, view::Size size) {
    problems.clear();
    shaders.assign(standing.passes.size(), nullptr);
    buffers.beginFrame();
    textures.keepOnly(standing);
    const auto drawPicture = [this](const Scene& picture, const ImageSource& known, double then,
                                    int extent) -> Result<Image> {
        if (const Result<void> done = drawScene(pictures, picture, known, then, {extent, extent}); !done)
            return fail(done.error());
        Image image = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
        device.read(*pictures.object, image);
        return image;
    };
    const Result<ImageSource> all =
        drawnPictures.addedTo(lightDepths.addedTo(images, standing, time), scene, time, drawPicture);
    if (!all)
        return fail(all.error());
    const Result<void> done = hasPictures(standing)
                                  ? drawScene(target, picturedScene(standing, 0), *all, time, size)
                                  : drawScene(target, standing, *all, time, size); // without a copy
    if (!done)
        return fail(done.error());
    // Passes of pictures that were not drawn again, for those who read them.
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        if (standing.passes[i].enabled && !shaders[i])
            compiled(standing, i, texturesOf(standing, i, *all));
    }
    return view::Frame{.picture = device.pictureOf(*target.object),
                       .size = size,
                       .problems = problems,
                       .shaders = shaders,
                       .pictures = all->pictures()};
}

Result<void> ScenePainter::State::drawScene(Surface& into, const Scene& scene, const ImageSource& images,
                                            double time, view::Size size) {
    if (!into.object || into.size != size) {
        into = {}; // free the old one first: both may not fit
        const unsigned made = device.makeTarget(size);
        if (made == 0)
            return fail(ErrorCode::Driver,
                        Sentence("the browser can't draw a picture of {0} pixels", asText(size)));
        into = {size, own(device, made, &Device::dropTarget)};
    }
    const Drawing drawing(device, *into.object, size, scene.view.background);
    const glm::mat4 projection =
        projectionMatrix(scene.view, static_cast<float>(size.width) / static_cast<float>(size.height));
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        if (scene.passes[i].enabled)
            drawPass(scene, i, texturesOf(scene, i, images), projection, time);
    }
    return {};
}

void ScenePainter::State::drawPass(const Scene& scene, std::size_t index, const BoundTextures& bound,
                                   const glm::mat4& projection, double time) {
    const Pass& pass = scene.passes[index];
    const Compiled* program = compiled(scene, index, bound);
    if (!program)
        return;
    const glsl::SampledUnits units = sampledUnits(bound, pass);
    std::array<view::CoordUse, maxUnits> uses{};
    device.setFragmentTests(pass);
    device.use(*program->program);
    const Uniforms uniforms(device);
    view::setPass(uniforms, scene, pass);
    for (int i = 0; i < maxUnits; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!units[at])
            continue;
        uses[at] =
            units[at]->lateFlip == LateFlip::Coordinates ? view::CoordUse::Flipped : view::CoordUse::AsGiven;
        device.setTexels(i, *bound[at].listed->texels);
        setSampler(uniforms, i, bound[at], pass.units[at]);
        view::setUnit(uniforms, at, pass.units[at]);
    }
    for (const std::size_t model : drawnModels(scene, pass)) {
        view::setModel(uniforms, scene, index, model, projection, units, time);
        drawModel(scene, pass, model, time, uses);
    }
}

void ScenePainter::State::drawModel(const Scene& scene, const Pass& pass, std::size_t index, double time,
                                    const std::array<view::CoordUse, maxUnits>& uses) {
    const Model& model = scene.models[index];
    const view::ModelBuffers::Bound bound = buffers.of(scene, pass, index, time, uses);
    const Mesh& mesh = *bound.mesh;
    if (mesh.vertices.empty())
        return;
    constexpr int stride = sizeof(Vertex);
    device.setAttribute(glsl::positionAttribute, **bound.vertices, 3, stride, offsetof(Vertex, position));
    device.setAttribute(glsl::normalAttribute, **bound.vertices, 3, stride, offsetof(Vertex, normal));
    if (mesh.colored)
        device.setAttribute(glsl::colorAttribute, **bound.vertices, 4, stride, offsetof(Vertex, color));
    else
        device.setAttribute(glsl::colorAttribute, materialOf(scene, model).color);
    for (std::size_t u = 0; u < bound.coords.size(); ++u) {
        const view::ModelBuffers::Coords& coords = bound.coords[u];
        const auto location = glsl::firstCoordAttribute + static_cast<unsigned>(u);
        if (coords.buffer)
            device.setAttribute(location, **coords.buffer, 4, coords.stride, coords.offset);
        else // WebGL refuses to draw with an array whose buffer is gone
            device.setAttribute(location, glm::vec4(0, 0, 0, 1));
    }
    const int pointSize = reference::roundedSize(model.pointSize);
    Uniforms(device).set("pointSize", static_cast<float>(pointSize));
    std::size_t first = 0;
    int corners = 3;
    for (const std::vector<std::uint32_t>* parts : {&mesh.triangles, &mesh.lines, &mesh.points}) {
        if (!parts->empty())
            device.draw(corners, **bound.indices, first, parts->size());
        first += parts->size();
        --corners;
    }
    if (const int width = reference::roundedSize(model.lineWidth); !mesh.lines.empty() && width > 1)
        report(Sentence("models[{0}]: a browser draws lines 1 pixel wide, not {1}", index, width));
    if (const int most = device.maxPointSize(); !mesh.points.empty() && pointSize > most)
        report(Sentence("models[{0}]: this browser draws points of at most {1} pixels, not {2}", index, most,
                        pointSize));
}

BoundTextures ScenePainter::State::texturesOf(const Scene& scene, std::size_t passIndex,
                                              const ImageSource& images) {
    BoundTextures bound{};
    const Pass& pass = scene.passes[passIndex];
    for (std::size_t u = 0; u < pass.units.size(); ++u) {
        const Unit& unit = pass.units[u];
        if (!unit.enabled)
            continue;
        if (unit.texture < 0 || std::cmp_greater_equal(unit.texture, scene.textures.size())) {
            report(Sentence(
                "passes[{0}].units[{1}]: there is no texture {2}, the scene has {3}; drawn without it",
                passIndex, u, unit.texture, scene.textures.size()));
            continue;
        }
        bound[u] =
            textures.prepare(scene, static_cast<std::size_t>(unit.texture), unit.target, images, problems);
    }
    return bound;
}

/// nullptr: it can't be drawn.
const ScenePainter::State::Compiled* ScenePainter::State::compiled(const Scene& scene, std::size_t pass,
                                                                   const BoundTextures& bound) {
    constexpr std::size_t maxPrograms = 256;
    const std::string where = fmt::format("passes[{}]", pass);
    Result<glsl::ShaderSource> source =
        glsl::shaderSource(scene, pass, sampledUnits(bound, scene.passes[pass]),
                           glsl::ShaderPieces::embedded(), glsl::Dialect::Es300);
    if (!source) {
        report(Sentence("{0}: {1}", ProperName{where}, describe(source.error())));
        return nullptr;
    }
    if (programs.size() > maxPrograms)
        programs.clear();
    const auto [found, isNew] = programs.try_emplace({source->vertex.text, source->fragment.text});
    Compiled& made = found->second;
    if (isNew) {
        const Device::Compiled built = device.makeProgram(source->vertex.text, source->fragment.text);
        std::vector<view::ShaderMessage> log;
        if (built.program != 0)
            made.program = own(device, built.program, &Device::dropProgram);
        else
            log.push_back({std::nullopt, 0, ProperName{built.log}});
        made.shader =
            std::make_shared<const view::PassShader>(view::PassShader{*std::move(source), std::move(log)});
    }
    shaders[pass] = made.shader;
    if (made.program)
        return &made;
    report(Sentence("{0}: {1}", ProperName{where}, made.shader->log.front().sentence));
    return nullptr;
}

void ScenePainter::State::report(Sentence sentence) {
    if (std::ranges::find(problems, sentence) == problems.end())
        problems.push_back(std::move(sentence));
}

} // namespace texplorer::gles

#include "app/gles/scene_painter.h"

#include "app/gles/texel_list.h"
#include "app/view/shader_uniforms.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/glsl/shader_source.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/reference/drawn_pictures.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/reference/sampling/texture_store.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>
#include <glm/vector_relational.hpp>

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

/// An object of the device, dropped with the last owner.
using Object = std::shared_ptr<const unsigned>;

Object own(Device& device, unsigned name, void (Device::*drop)(unsigned)) {
    return {new unsigned(name), [&device, drop](const unsigned* at) {
                (device.*drop)(*at);
                delete at;
            }};
}

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

/// A texture of the scene on the device.
struct Listed {
    std::uint64_t version = 0; ///< of reference::StoredTexture
    Object texels;             ///< nullptr: the device can't hold them
    std::vector<std::optional<glm::ivec4>> levels;
    bool isUnclamped = false; ///< its texels may lie outside 0 … 1
    Sentence problem;
    bool used = true; ///< in the current frame
};

/// What a unit samples.
struct BoundTexture {
    const reference::StoredTexture* stored = nullptr; ///< nullptr: nothing
    const Listed* listed = nullptr;
};
using BoundTextures = std::array<BoundTexture, maxUnits>;

bool isOutside(const glm::vec4& texel) {
    return !glm::all(glm::greaterThanEqual(texel, glm::vec4(0))) ||
           !glm::all(glm::lessThanEqual(texel, glm::vec4(1)));
}

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

/// The levels that minification uses, from the base level on.
std::vector<glm::ivec4> listedLevels(const Listed& listed, const reference::SampledTexture& texture,
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
    explicit State(Device& given)
        : device(given)
        , buffers([this](view::BufferKind kind, std::span<const std::byte> content) {
            return own(device, device.makeBuffer(kind, content), &Device::dropBuffer);
        }) {}

    struct Surface {
        view::Size size;
        Object object;
    };
    struct Compiled {
        Object program; ///< nullptr: it does not compile
        std::shared_ptr<const view::PassShader> shader;
    };
    /// The inputs of a picture.
    struct Drawn {
        Scene scene;
        ImageSource images;
        double time = 0;
        view::Size size;

        bool operator==(const Drawn&) const = default;
    };

    Result<void> begin(Surface& into, view::Size size, const glm::vec4& background);
    void drawScene(const Scene& scene, const ImageSource& images, double time, view::Size size);
    void drawPass(const Scene& scene, std::size_t pass, const BoundTextures& bound,
                  const glm::mat4& projection, double time);
    void drawModel(const Scene& scene, const Pass& pass, std::size_t model, double time,
                   const std::array<view::CoordUse, maxUnits>& uses);
    BoundTextures texturesOf(const Scene& scene, std::size_t pass, const ImageSource& images);
    const Listed& listedOf(const reference::StoredTexture& stored, std::size_t texture);
    const Compiled* compiled(const Scene& scene, std::size_t pass, const glsl::SampledUnits& units);
    void report(Sentence sentence);

    Device& device;
    view::ModelBuffers buffers;
    Surface target;
    Surface pictures; ///< that textures show
    reference::TextureStore textures;
    reference::LightDepths lightDepths;
    reference::DrawnPictures drawnPictures;
    std::map<std::pair<std::size_t, Target>, Listed> lists;
    std::map<std::pair<std::string, std::string>, Compiled> programs; ///< by their two sources
    std::vector<std::shared_ptr<const view::PassShader>> shaders;     ///< of the current frame, by pass
    std::vector<Sentence> problems;                                   ///< of the current frame
    std::optional<Drawn> drawn;
    std::uint64_t revision = 0;
};

ScenePainter::ScenePainter(Device& device)
    : state_(std::make_unique<State>(device)) {}
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
    const auto begin = std::chrono::steady_clock::now();
    view::Frame frame{.size = size};
    try {
        const StandingScene standing(scene, time);
        state.problems.clear();
        state.shaders.assign(standing->passes.size(), nullptr);
        state.buffers.beginFrame();
        state.textures.keepOnly(*standing);
        const auto drawPicture = [&state](const Scene& picture, const ImageSource& known, double then,
                                          int extent) -> Result<Image> {
            const view::Size square{extent, extent};
            if (Result<void> begun = state.begin(state.pictures, square, picture.view.background); !begun)
                return fail(begun.error());
            state.drawScene(picture, known, then, square);
            Image image = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
            state.device.read(*state.pictures.object, image);
            return image;
        };
        const Result<ImageSource> all = state.drawnPictures.addedTo(
            state.lightDepths.addedTo(images, *standing, time), scene, time, drawPicture);
        if (!all)
            return fail(all.error());
        if (const Result<void> begun = state.begin(state.target, size, standing->view.background); !begun)
            return fail(begun.error());
        if (hasPictures(*standing))
            state.drawScene(picturedScene(*standing, 0), *all, time, size);
        else // without a copy
            state.drawScene(*standing, *all, time, size);
        std::erase_if(state.lists, [](const auto& entry) { return !entry.second.used; });
        for (auto& [place, listed] : state.lists)
            listed.used = false;
        State::Drawn inputs{*standing, *all, time, size};
        if (state.drawn != inputs) {
            state.drawn = std::move(inputs);
            ++state.revision;
        }
        frame.pictures = all->pictures();
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for the scene's images and meshes");
    }
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    frame.picture = state.device.pictureOf(*state.target.object);
    frame.milliseconds = elapsed.count();
    frame.problems = state.problems;
    frame.shaders = state.shaders;
    frame.revision = state.revision;
    return frame;
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

Result<void> ScenePainter::State::begin(Surface& into, view::Size size, const glm::vec4& background) {
    if (!into.object || into.size != size) {
        into = {}; // free the old one first: both may not fit
        const unsigned made = device.makeTarget(size);
        if (made == 0)
            return fail(ErrorCode::Driver,
                        Sentence("the browser can't draw a picture of {0} pixels", asText(size)));
        into = {size, own(device, made, &Device::dropTarget)};
    }
    device.begin(*into.object, size, background);
    return {};
}

void ScenePainter::State::drawScene(const Scene& scene, const ImageSource& images, double time,
                                    view::Size size) {
    const glm::mat4 projection =
        projectionMatrix(scene.view, static_cast<float>(size.width) / static_cast<float>(size.height));
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        if (scene.passes[i].enabled)
            drawPass(scene, i, texturesOf(scene, i, images), projection, time);
    }
    device.end();
}

void ScenePainter::State::drawPass(const Scene& scene, std::size_t index, const BoundTextures& bound,
                                   const glm::mat4& projection, double time) {
    const Pass& pass = scene.passes[index];
    glsl::SampledUnits units;
    std::array<view::CoordUse, maxUnits> uses{};
    for (std::size_t u = 0; u < units.size(); ++u) {
        if (!bound[u].stored)
            continue;
        units[u] = sampledUnit(bound[u], pass);
        uses[u] = bound[u].stored->lateFlip == LateFlip::Coordinates ? view::CoordUse::Flipped
                                                                     : view::CoordUse::AsGiven;
    }
    const Compiled* program = compiled(scene, index, units);
    if (!program || !program->program)
        return;
    shaders[index] = program->shader;
    device.setFragmentTests(pass);
    device.use(*program->program);
    const Uniforms uniforms(device);
    view::setPass(uniforms, scene, pass);
    for (int i = 0; i < maxUnits; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!units[at])
            continue;
        device.setTexels(i, *bound[at].listed->texels);
        setSampler(uniforms, i, bound[at], pass.units[at]);
        view::setUnit(uniforms, at, pass.units[at]);
    }
    for (const std::size_t model : drawnModels(scene, pass)) {
        view::setModel(uniforms, scene, index, model, projection, units, time);
        uniforms.set("pointSize", scene.models[model].pointSize);
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
        if (coords.buffer)
            device.setAttribute(glsl::firstCoordAttribute + static_cast<unsigned>(u), **coords.buffer, 4,
                                coords.stride, coords.offset);
    }
    std::size_t first = 0;
    int corners = 3;
    for (const std::vector<std::uint32_t>* parts : {&mesh.triangles, &mesh.lines, &mesh.points}) {
        if (!parts->empty())
            device.draw(corners, **bound.indices, first, parts->size());
        first += parts->size();
        --corners;
    }
    if (!mesh.lines.empty() && model.lineWidth > 1)
        report(Sentence("models[{0}]: a browser draws lines 1 pixel wide, not {1}", index,
                        ProperName{fmt::format("{}", model.lineWidth)}));
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
        const auto index = static_cast<std::size_t>(unit.texture);
        const reference::StoredTexture* stored =
            textures.prepare(scene, index, unit.target, images, LevelWork{}, problems);
        if (!stored || !stored->complete)
            continue;
        const Listed& listed = listedOf(*stored, index);
        if (!listed.texels)
            report(Sentence("{0}: {1}", ProperName{fmt::format("textures[{}]", index)}, listed.problem));
        else
            bound[u] = {stored, &listed};
    }
    return bound;
}

const Listed& ScenePainter::State::listedOf(const reference::StoredTexture& stored, std::size_t texture) {
    Listed& listed = lists[{texture, stored.sampled.target}];
    listed.used = true;
    if (listed.version == stored.version)
        return listed;
    listed = {};
    listed.version = stored.version;
    const std::size_t rows = rowsOf(stored.sampled);
    const int limit = device.maxTextureSize();
    unsigned made = 0;
    if (std::cmp_less_equal(rows, limit)) {
        TexelList list = texelList(stored.sampled);
        made = device.makeTexels(list.texels, list.rows, list.floats);
        listed.levels = std::move(list.levels);
        listed.isUnclamped =
            isFloat(stored.sampled.internalFormat) ||
            (list.floats && std::ranges::any_of(stored.sampled.levels, [](const auto& level) {
                 return std::ranges::any_of(level.texels, isOutside);
             }));
    }
    if (made == 0)
        listed.problem =
            Sentence("the browser can't hold its {0} texels; drawn without it", rows * glsl::texelsPerRow);
    else
        listed.texels = own(device, made, &Device::dropTexels);
    return listed;
}

const ScenePainter::State::Compiled* ScenePainter::State::compiled(const Scene& scene, std::size_t pass,
                                                                   const glsl::SampledUnits& units) {
    constexpr std::size_t maxPrograms = 256;
    const std::string where = fmt::format("passes[{}]", pass);
    Result<glsl::ShaderSource> source =
        glsl::shaderSource(scene, pass, units, glsl::ShaderPieces::embedded(), glsl::Dialect::Es300);
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
    if (!made.program)
        report(Sentence("{0}: {1}", ProperName{where}, made.shader->log.front().sentence));
    return &made;
}

void ScenePainter::State::report(Sentence sentence) {
    if (std::ranges::find(problems, sentence) == problems.end())
        problems.push_back(std::move(sentence));
}

} // namespace texplorer::gles

#include "core/reference/probe.h"

#include "core/reference/raster/raster.h"
#include "core/reference/raster/shade.h"
#include "core/reference/sampling/completeness.h"
#include "core/reference/sampling/sampler.h"
#include "core/reference/shading/fragment.h"
#include "core/reference/shading/stored_color.h"
#include "core/reference/shading/vertex_stage.h"
#include "core/scene/animation.h"
#include "core/scene/tex_coords.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

PixelBytes bytesOf(glm::vec4 color) {
    std::array<std::byte, 4> stored{};
    store(color, stored.data());
    PixelBytes bytes{};
    for (std::size_t i = 0; i < 4; ++i)
        bytes[i] = std::to_integer<std::uint8_t>(stored[i]);
    return bytes;
}

/// A pixel of the framebuffer on its own.
struct Framebuffer {
    std::array<std::byte, 4> color{};
    std::uint32_t depth = farthestDepth;

    [[nodiscard]] PixelBytes bytes() const { return bytesOf(colorOf(color.data())); }
};

std::string faceOf(const Mesh& mesh, std::size_t triangle) {
    const auto holds = [](const Face& face, std::uint32_t vertex) {
        return std::ranges::find(face.vertices, vertex) != face.vertices.end();
    };
    for (const Face& face : mesh.faces) {
        if (holds(face, mesh.triangles[triangle]) && holds(face, mesh.triangles[triangle + 1]) &&
            holds(face, mesh.triangles[triangle + 2]))
            return face.name;
    }
    return {};
}

/// Whether a triangle whose corners all lie before the eye can't reach the pixel: cheaper than to set it up.
/// One pixel is allowed for rounding.
bool passesBy(const std::array<glm::vec4, 3>& clip, PixelPlace pixel, Viewport viewport) {
    glm::vec2 low(INFINITY);
    glm::vec2 high(-INFINITY);
    for (const glm::vec4& corner : clip) {
        if (!(corner.w > 1e-6F))
            return false;
        const glm::vec2 window =
            (glm::vec2(corner) / corner.w + 1.0F) / 2.0F * glm::vec2(viewport.width, viewport.height);
        low = glm::min(low, window);
        high = glm::max(high, window);
    }
    const glm::vec2 centre = glm::vec2(pixel.x, pixel.y) + 0.5F;
    return centre.x < low.x - 1 || centre.y < low.y - 1 || centre.x > high.x + 1 || centre.y > high.y + 1;
}

/// The part of a clipped triangle that covers the pixel, and which share its corners have in what is
/// interpolated there.
struct Cover {
    Triangle triangle;
    glm::vec3 weights{0};
    bool clipped = false;
};

class Prober {
public:
    Prober(Explanation& explanation, const Scene& scene, Viewport viewport)
        : explanation_(explanation)
        , scene_(scene)
        , viewport_(viewport) {
        store(scene.view.background, framebuffer_.color.data());
    }

    void draw(const PassState& pass, std::size_t passIndex, std::size_t modelIndex,
              const glm::mat4& modelview, const glm::mat4& projection);

    [[nodiscard]] PixelBytes bytes() const { return framebuffer_.bytes(); }

private:
    [[nodiscard]] std::vector<Cover> cover(const std::array<ShadedVertex, 3>& corners,
                                           const PassState& pass) const;
    void draw(FragmentExplanation fragment, const Cover& cover, const PassState& pass,
              const std::array<VertexRecord, 3>& records,
              const std::array<std::array<glm::vec4, maxUnits>, 3>& given);
    void explainUnits(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                      const std::array<VertexRecord, 3>& records,
                      const std::array<std::array<glm::vec4, maxUnits>, 3>& given) const;
    [[nodiscard]] glm::vec2 offsetOf(const Triangle& triangle) const {
        return glm::vec2(explanation_.pixel.x, explanation_.pixel.y) - triangle.origin;
    }
    void test(FragmentExplanation& fragment, const Triangle& triangle);

    Explanation& explanation_;
    const Scene& scene_;
    Viewport viewport_;
    Framebuffer framebuffer_;
};

/// As a picture's triangles are made: see draw.cpp.
std::vector<Cover> Prober::cover(const std::array<ShadedVertex, 3>& corners, const PassState& pass) const {
    std::vector<Cover> found;
    // What a corner contributes is found as any colour is: each is given a primary colour of its own.
    std::array<ShadedVertex, 3> marked = corners;
    for (int i = 0; i < 3; ++i) {
        marked[static_cast<std::size_t>(i)].primary = glm::vec4(0);
        marked[static_cast<std::size_t>(i)].primary[i] = 1;
    }
    const Polygon polygon = clip(corners[0], corners[1], corners[2], pass.perspective);
    if (polygon.size() < 3)
        return found;
    const Polygon weights = clip(marked[0], marked[1], marked[2], pass.perspective);
    const auto [x, y] = explanation_.pixel;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const auto triangle =
            setUp(polygon[0], polygon[i - 1], polygon[i], pass, viewport_, pass.perspective);
        if (!triangle)
            continue;
        bool covered = false;
        eachCoveredRow(*triangle, {x, x, y, y}, [&](int, int, int) { covered = true; });
        if (!covered)
            continue;
        const auto shares = setUp(weights[0], weights[i - 1], weights[i], pass, viewport_, pass.perspective);
        const glm::vec2 offset = offsetOf(*triangle);
        const glm::vec4 share = shares ? shares->primary.at(offset) / shares->invW.at(offset) : glm::vec4(0);
        const bool cut = polygon.size() > 3 || polygon[0].clip != corners[0].clip ||
                         polygon[1].clip != corners[1].clip || polygon[2].clip != corners[2].clip;
        found.push_back({*triangle, glm::vec3(share), cut});
    }
    return found;
}

void Prober::draw(const PassState& pass, std::size_t passIndex, std::size_t modelIndex,
                  const glm::mat4& modelview, const glm::mat4& projection) {
    const Model& model = scene_.models[modelIndex];
    const Mesh mesh = makeMesh(model.shape, model.slices, model.stacks);
    const VertexStage stage(scene_, pass, modelview, projection);
    std::vector<glm::vec4> clipped;
    clipped.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        clipped.push_back(stage.clip(vertex));

    std::array<TexCoords, maxUnits> lists; // filled when the first triangle needs them
    bool listed = false;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const std::array<std::uint32_t, 3> vertices{mesh.triangles[i], mesh.triangles[i + 1],
                                                    mesh.triangles[i + 2]};
        if (passesBy({clipped[vertices[0]], clipped[vertices[1]], clipped[vertices[2]]}, explanation_.pixel,
                     viewport_))
            continue;
        if (!listed) {
            for (int u = 0; u < pass.unitsUsed; ++u)
                lists[static_cast<std::size_t>(u)] = effectiveTexCoords(model, mesh, u);
            listed = true;
        }
        std::array<VertexRecord, 3> records;
        std::array<std::array<glm::vec4, maxUnits>, 3> given{};
        std::array<ShadedVertex, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u)
                given[c][u] = lists[u][vertices[c]];
            records[c] = stage.explain(mesh.vertices[vertices[c]], given[c]);
            corners[c] = records[c].shaded;
        }
        if (pass.flat) { // section 2.14.7: the colours of the last vertex
            corners[0].primary = corners[1].primary = corners[2].primary;
            corners[0].secondary = corners[1].secondary = corners[2].secondary;
        }
        for (const Cover& part : cover(corners, pass)) {
            FragmentExplanation fragment;
            fragment.pass = static_cast<int>(passIndex);
            fragment.model = static_cast<int>(modelIndex);
            fragment.shape = model.shape;
            fragment.triangle = static_cast<std::uint32_t>(i / 3);
            fragment.face = faceOf(mesh, i);
            fragment.clipped = part.clipped;
            for (std::size_t c = 0; c < 3; ++c) {
                VertexExplanation& vertex = fragment.vertices[c];
                vertex.vertex = vertices[c];
                vertex.weight = part.weights[static_cast<int>(c)];
                vertex.object = glm::vec4(mesh.vertices[vertices[c]].position, 1);
                vertex.eye = records[c].eye;
                vertex.normal = records[c].normal;
                vertex.clip = records[c].shaded.clip;
                if (pass.pass->lighting)
                    vertex.lighting = records[c].lighting;
                vertex.primary = records[c].shaded.primary;
                vertex.secondary = records[c].shaded.secondary;
            }
            draw(std::move(fragment), part, pass, records, given);
        }
    }
}

/// Where a level is among those that were read, only its extents are of interest.
std::vector<LevelExtent> extentsOf(const SampledTexture& texture, const SampleRecord& sample) {
    std::vector<LevelExtent> extents;
    for (const LevelShare& share : sample.levels) {
        if (const Level* level = texture.level(share.level))
            extents.push_back({share.level, level->size(), level->border});
    }
    return extents;
}

void Prober::explainUnits(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                          const std::array<VertexRecord, 3>& records,
                          const std::array<std::array<glm::vec4, maxUnits>, 3>& given) const {
    const glm::vec2 offset = offsetOf(cover.triangle);
    std::array<glm::vec4, maxUnits> samples{};
    std::array<const glm::vec4*, maxUnits> sources{};
    const auto used = static_cast<std::size_t>(pass.unitsUsed);
    for (std::size_t u = 0; u < used; ++u) {
        const UnitState& state = pass.units[u];
        if (!state.texture)
            continue;
        UnitExplanation& unit = fragment.units.emplace_back();
        unit.unit = static_cast<int>(u);
        unit.texture = state.unit->texture;
        unit.target = state.texture->target;
        unit.format = state.texture->format;
        unit.generates = {state.unit->texGenS.enabled, state.unit->texGenT.enabled,
                          state.unit->texGenR.enabled, state.unit->texGenQ.enabled};
        for (std::size_t c = 0; c < 3; ++c) {
            CoordinateSteps& steps = unit.vertices[c];
            steps = {given[c][u], records[c].generated[u], records[c].shaded.texCoords[u]};
            const float weight = fragment.vertices[c].weight;
            if (c == 0)
                unit.pixel = {glm::vec4(0), glm::vec4(0), glm::vec4(0)};
            unit.pixel.given += weight * steps.given;
            unit.pixel.generated += weight * steps.generated;
        }
        unit.matrix = state.matrix;
        unit.flipped = state.flipsCoordinates;
        const TexturePlace place = texturePlace(cover.triangle, u, offset);
        unit.pixel.transformed = place.homogeneous;
        unit.coords = place.coords;
        unit.derivatives = place.derivatives;
        unit.sampler = static_cast<const SamplerState&>(*state.texture);
        unit.lodBias = state.sampling.unitBias;
        unit.sample = explainSample(*state.texture, place.coords, place.derivatives, state.sampling);
        unit.extents = extentsOf(*state.texture, unit.sample);
        unit.patches = levelPatches(*state.texture, unit.sample, place.coords);
        samples[u] = unit.sample.color;
        sources[u] = &samples[u];
    }
    glm::vec4 color = fragment.primary;
    for (UnitExplanation& unit : fragment.units) {
        const auto u = static_cast<std::size_t>(unit.unit);
        const UnitState& state = pass.units[u];
        unit.mode = state.unit->envMode;
        unit.inputs = {color, samples[u], state.envColor, fragment.primary};
        if (unit.mode == EnvMode::Combine) {
            unit.equations = equationsOf(state.unit->combine, unit.inputs, sources);
            unit.result = evaluate(state.unit->combine, unit.inputs, sources).color;
        } else {
            unit.equations = equationsOf(unit.mode, unit.format, unit.inputs);
            unit.result = evaluate(unit.mode, unit.format, unit.inputs).color;
        }
        color = unit.result;
    }
    fragment.textured = color;
}

/// Section 4.1, in its order.
void Prober::test(FragmentExplanation& fragment, const Triangle& triangle) {
    const Pass& pass = *triangle.pass->pass;
    fragment.before = fragment.after = framebuffer_.bytes();
    fragment.alphaTest.enabled = pass.alphaTest;
    fragment.alphaTest.function = pass.alphaFunc;
    fragment.alphaTest.value = fragment.color.a;
    fragment.alphaTest.with = std::clamp(pass.alphaRef, 0.0F, 1.0F);
    fragment.alphaTest.passed =
        !pass.alphaTest || passes(pass.alphaFunc, fragment.alphaTest.value, fragment.alphaTest.with);

    fragment.depth = glm::clamp(triangle.depth.at(offsetOf(triangle)), 0.0F, 1.0F);
    fragment.depthTest.enabled = pass.depthTest;
    fragment.depthTest.function = pass.depthFunc;
    fragment.depthTest.value = fragmentDepth(triangle, offsetOf(triangle));
    fragment.depthTest.with = framebuffer_.depth;
    fragment.depthTest.passed =
        !pass.depthTest || passes(pass.depthFunc, fragment.depthTest.value, fragment.depthTest.with);
    if (!fragment.alphaTest.passed || !fragment.depthTest.passed) {
        fragment.outcome =
            fragment.alphaTest.passed ? FragmentOutcome::FailedDepthTest : FragmentOutcome::FailedAlphaTest;
        return;
    }
    if (pass.depthTest)
        framebuffer_.depth = fragment.depthTest.value;

    BlendExplanation& mixed = fragment.blend;
    mixed.enabled = pass.blend;
    mixed.source = mixed.result = fragment.color;
    mixed.destination = colorOf(framebuffer_.color.data());
    if (pass.blend) {
        mixed.sourceFactor = pass.blendSrc;
        mixed.destinationFactor = pass.blendDst;
        mixed.sourceWeight = blendFactor(pass.blendSrc, mixed.source, mixed.destination);
        mixed.destinationWeight = blendFactor(pass.blendDst, mixed.source, mixed.destination);
        mixed.result = blend(pass.blendSrc, pass.blendDst, mixed.source, mixed.destination);
    }
    store(mixed.result, framebuffer_.color.data());
    fragment.after = framebuffer_.bytes();
    explanation_.color = mixed.result;
}

void Prober::draw(FragmentExplanation fragment, const Cover& cover, const PassState& pass,
                  const std::array<VertexRecord, 3>& records,
                  const std::array<std::array<glm::vec4, maxUnits>, 3>& given) {
    const Triangle& triangle = cover.triangle;
    const glm::vec2 offset = offsetOf(triangle);
    fragment.lighting = pass.pass->lighting;
    fragment.flat = pass.flat;
    fragment.separateSpecular = pass.separateSpecular;
    fragment.primary = primaryColor(triangle, offset);
    if (pass.separateSpecular)
        fragment.secondary =
            glm::clamp(triangle.secondary.at(offset) * (1 / triangle.invW.at(offset)), 0.0F, 1.0F);
    explainUnits(fragment, cover, pass, records, given);
    // The picture's own arithmetic has the last word: it may round otherwise than what explains it.
    fragment.color = fragmentColor(triangle, offset);
    test(fragment, triangle);
    explanation_.fragments.push_back(std::move(fragment));
}

/// Units that are on and have nothing to sample. The same for every fragment of a pass.
std::vector<IdleUnit> idleUnits(const Scene& scene, const PassState& pass, const ImageSource& images,
                                const LevelWork& work, TextureStore& textures) {
    std::vector<IdleUnit> idle;
    for (std::size_t u = 0; u < pass.pass->units.size(); ++u) {
        const Unit& unit = pass.pass->units[u];
        if (!unit.enabled || pass.units[u].texture)
            continue;
        const std::string name = fmt::format("textures[{}]", unit.texture);
        std::string reason = "there is no " + name;
        if (unit.texture >= 0 && static_cast<std::size_t>(unit.texture) < scene.textures.size()) {
            std::vector<std::string> said;
            const StoredTexture* stored = textures.prepare(scene, static_cast<std::size_t>(unit.texture),
                                                           unit.target, images, work, said);
            reason =
                stored ? fmt::format("{} is incomplete: {}", name, checkCompleteness(stored->sampled).reason)
                : !said.empty() ? said.front()
                                : name + " can't be drawn";
        }
        idle.push_back({static_cast<int>(u), std::move(reason)});
    }
    return idle;
}

} // namespace

Result<Explanation> explainPixel(const DrawRequest& request, PixelPlace pixel, const DrawOptions& options,
                                 TextureStore& textures) {
    const auto& [scene, images, time, width, height, anisotropy] = request;
    const Viewport viewport{width, height};
    const auto stopped = [] { return fail(ErrorCode::Cancelled, "the probe was stopped"); };
    Explanation explanation;
    explanation.pixel = pixel;
    explanation.width = viewport.width;
    explanation.height = viewport.height;
    explanation.time = time;
    explanation.background = explanation.color = glm::clamp(scene.view.background, 0.0F, 1.0F);
    const std::vector<PassState> passes =
        passStates(scene, images, time, options.levels, anisotropy, textures, explanation.problems);
    if (options.isStopped())
        return stopped();
    const glm::mat4 view = viewMatrix(scene.view);
    const glm::mat4 projection = projectionMatrix(scene.view, static_cast<float>(viewport.width) /
                                                                  static_cast<float>(viewport.height));
    Prober prober(explanation, scene, viewport);
    for (std::size_t p = 0; p < passes.size(); ++p) {
        if (!scene.passes[p].enabled)
            continue;
        const std::size_t first = explanation.fragments.size();
        for (std::size_t m = 0; m < scene.models.size(); ++m) {
            if (scene.models[m].visible && !options.stop.stop_requested())
                prober.draw(passes[p], p, m, view * modelMatrix(scene.models[m], time), projection);
        }
        if (explanation.fragments.size() == first)
            continue;
        const std::vector<IdleUnit> idle = idleUnits(scene, passes[p], images, options.levels, textures);
        for (std::size_t i = first; i < explanation.fragments.size(); ++i)
            explanation.fragments[i].idle = idle;
    }
    if (options.isStopped())
        return stopped();
    explanation.bytes = prober.bytes();
    return explanation;
}

Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel, const DrawOptions& options) {
    return ReferenceRenderer().probe(request, pixel, options);
}

} // namespace texplorer::reference

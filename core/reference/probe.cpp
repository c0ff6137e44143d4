#include "texplorer/reference/probe.h"

#include "texplorer/reference/face_name.h"
#include "texplorer/reference/raster/assembly.h"
#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/raster/shade.h"
#include "texplorer/reference/sampling/completeness.h"
#include "texplorer/reference/sampling/sampler.h"
#include "texplorer/reference/shading/fog.h"
#include "texplorer/reference/shading/fragment.h"
#include "texplorer/reference/shading/stored_color.h"
#include "texplorer/reference/shading/vertex_stage.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

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

/// Whether a part whose corners all lie before the eye can't reach the pixel: cheaper than to set it up.
/// `margin` pixels are allowed for rounding and for the width of lines and points.
bool passesBy(std::span<const std::uint32_t> part, const std::vector<glm::vec4>& clipped, PixelPlace pixel,
              Viewport viewport, float margin) {
    glm::vec2 low(INFINITY);
    glm::vec2 high(-INFINITY);
    for (const std::uint32_t vertex : part) {
        const glm::vec4& corner = clipped[vertex];
        if (!(corner.w > 1e-6F))
            return false;
        const glm::vec2 window =
            (glm::vec2(corner) / corner.w + 1.0F) / 2.0F * glm::vec2(viewport.width, viewport.height);
        low = glm::min(low, window);
        high = glm::max(high, window);
    }
    const glm::vec2 centre = glm::vec2(pixel.x, pixel.y) + 0.5F;
    return centre.x < low.x - margin || centre.y < low.y - margin || centre.x > high.x + margin ||
           centre.y > high.y + margin;
}

/// What clipping left of a part and covers the pixel, and which share its corners have in what is
/// interpolated there.
struct Cover {
    Triangle triangle;
    glm::vec3 weights{0};
    bool clipped = false;
};

class Prober {
public:
    /// Explains maxExplainedFragments from number `first` on, and draws all.
    Prober(Explanation& explanation, const Scene& scene, Viewport viewport, std::size_t first)
        : explanation_(explanation)
        , scene_(scene)
        , viewport_(viewport)
        , first_(first) {
        store(scene.view.background, framebuffer_.color.data());
        explanation_.firstFragment = first;
    }

    void draw(const PassState& pass, std::size_t passIndex, std::size_t modelIndex,
              const glm::mat4& projection);

    [[nodiscard]] PixelBytes bytes() const { return framebuffer_.bytes(); }

    /// Of all fragments, with coordinates and lambda rounded to these sides (ties.h).
    [[nodiscard]] PixelBytes bytesRounded(glm::vec4 signs) const;

    /// The number of the first fragment to explain, so that the last one is that which one sees.
    [[nodiscard]] std::size_t firstWanted() const {
        const std::size_t end = seen_ ? *seen_ + 1 : explanation_.fragmentCount;
        return end - std::min(end, maxExplainedFragments);
    }

private:
    /// One set of coordinates a unit, for each corner of a part.
    using Coords = std::vector<std::array<glm::vec4, maxUnits>>;

    [[nodiscard]] std::vector<Cover> cover(std::span<const ShadedVertex> corners, const PassState& pass,
                                           const Model& model) const;
    void explain(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                 const std::vector<VertexRecord>& records, const Coords& given, const Coords& embossed) const;
    void explainUnits(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                      const std::vector<VertexRecord>& records, const Coords& given,
                      const Coords& embossed) const;
    [[nodiscard]] glm::vec2 offsetOf(const Triangle& triangle) const {
        return glm::vec2(explanation_.pixel.x, explanation_.pixel.y) - triangle.origin;
    }
    void test(FragmentExplanation& fragment, const Triangle& triangle);

    Explanation& explanation_;
    const Scene& scene_;
    Viewport viewport_;
    std::size_t first_;
    Framebuffer framebuffer_;
    std::optional<std::size_t> seen_{}; ///< the last fragment that was drawn
    std::vector<Triangle> explained_{};
};

/// As a picture's triangles, lines and points are made: see scene_triangles.cpp.
std::vector<Cover> Prober::cover(std::span<const ShadedVertex> corners, const PassState& pass,
                                 const Model& model) const {
    // What a corner contributes is found as any colour is: each is given a primary colour of its own.
    std::vector<ShadedVertex> marked(corners.begin(), corners.end());
    for (std::size_t i = 0; i < marked.size(); ++i) {
        marked[i].primary = glm::vec4(0);
        marked[i].primary[static_cast<int>(i)] = 1;
        marked[i].back.primary = marked[i].primary;
    }
    const auto assembled = [&](std::span<const ShadedVertex> part, bool flat) {
        std::vector<Triangle> made;
        PassState shading = pass;
        shading.flat = flat;
        const std::function<void(const Triangle&)> keep = [&made](const Triangle& each) {
            made.push_back(each);
        };
        Assembly(shading, model, viewport_, keep).add(part);
        for (Triangle& each : made)
            each.pass = &pass;
        return made;
    };
    const std::vector<Triangle> parts = assembled(corners, pass.flat);
    const std::vector<Triangle> shares = assembled(marked, false);
    const bool cut = corners.size() == 3 && !isInside(corners[0], corners[1], corners[2]);
    const auto [x, y] = explanation_.pixel;
    std::vector<Cover> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        bool covered = false;
        eachCoveredRow(parts[i], {x, x, y, y}, [&](int, int, int) { covered = true; });
        if (!covered)
            continue;
        const glm::vec2 offset = offsetOf(parts[i]);
        const glm::vec4 share =
            i < shares.size() ? shares[i].primary.at(offset) / shares[i].invW.at(offset) : glm::vec4(0);
        found.push_back({parts[i], glm::vec3(share), cut});
    }
    return found;
}

void Prober::draw(const PassState& pass, std::size_t passIndex, std::size_t modelIndex,
                  const glm::mat4& projection) {
    const SentModel sentModel(scene_.models[modelIndex]);
    const Model& model = *sentModel;
    const Mesh mesh = meshOf(model);
    const VertexStage stage(scene_, pass, modelIndex, mesh,
                            modelViewMatrix(scene_.view, model, explanation_.time), projection,
                            {viewport_.width, viewport_.height, viewport_.cornerBits});
    std::vector<glm::vec4> clipped;
    clipped.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        clipped.push_back(stage.clip(vertex));
    const float margin =
        1 + static_cast<float>(std::max(mesh.lines.empty() ? 0 : roundedSize(model.lineWidth),
                                        mesh.points.empty() ? 0 : roundedSize(model.pointSize)));

    std::array<TexCoords, maxUnits> own; // filled when the first part needs them
    std::array<TexCoords, maxUnits> moved;
    bool listed = false;
    eachPart(mesh, [&](std::span<const std::uint32_t> part, std::size_t number) {
        if (passesBy(part, clipped, explanation_.pixel, viewport_, margin))
            return;
        if (!listed) {
            for (int u = 0; u < pass.unitsUsed; ++u)
                own[static_cast<std::size_t>(u)] = effectiveTexCoords(model, mesh, u);
            moved = givenTexCoords(scene_, pass, model, mesh, explanation_.time);
            listed = true;
        }
        std::vector<VertexRecord> records;
        Coords given(part.size());
        Coords embossed(part.size());
        std::vector<ShadedVertex> corners;
        for (std::size_t c = 0; c < part.size(); ++c) {
            for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
                given[c][u] = own[u][part[c]];
                embossed[c][u] = moved[u][part[c]];
            }
            records.push_back(stage.explain(mesh.vertices[part[c]], embossed[c]));
            corners.push_back(records[c].shaded);
        }
        for (const Cover& covering : cover(corners, pass, model)) {
            const std::size_t count = explanation_.fragmentCount++;
            const bool isExplained = count >= first_ && count - first_ < maxExplainedFragments;
            FragmentExplanation fragment;
            // The picture's own arithmetic has the last word: it may round otherwise than what explains it.
            fragment.color = fragmentColor(covering.triangle, offsetOf(covering.triangle));
            test(fragment, covering.triangle);
            if (fragment.outcome == FragmentOutcome::Drawn)
                seen_ = count;
            if (!isExplained)
                continue;
            fragment.pass = static_cast<int>(passIndex);
            fragment.model = static_cast<int>(modelIndex);
            fragment.shape = scene_.models[modelIndex].shape;
            fragment.part = static_cast<std::uint32_t>(number);
            fragment.face = faceName(sentModel, mesh, part);
            fragment.clipped = covering.clipped;
            fragment.coloredVertices = mesh.colored;
            fragment.fromBehind = covering.triangle.seenFromBehind;
            const bool back = pass.twoSided && fragment.fromBehind;
            for (std::size_t c = 0; c < part.size(); ++c) {
                VertexExplanation& vertex = fragment.vertices.emplace_back();
                vertex.vertex = sentModel.vertexOf(part[c]);
                vertex.weight = covering.weights[static_cast<int>(c)];
                vertex.object = glm::vec4(mesh.vertices[part[c]].position, 1);
                vertex.eye = records[c].eye;
                vertex.normal = records[c].normal;
                vertex.clip = records[c].shaded.clip;
                if (pass.pass->lighting)
                    vertex.lighting = back ? records[c].backLighting : records[c].lighting;
                const ShadedVertex& shaded = records[c].shaded;
                vertex.primary = back ? shaded.back.primary : shaded.primary;
                vertex.secondary = back ? shaded.back.secondary : shaded.secondary;
            }
            explain(fragment, covering, pass, records, given, embossed);
            for (UnitExplanation& unit : fragment.units)
                for (std::size_t c = 0; c < part.size(); ++c)
                    unit.vertices[c].of = sentModel.coordsOf(part[c], static_cast<std::size_t>(unit.unit));
            explanation_.fragments.push_back(std::move(fragment));
            explained_.push_back(covering.triangle);
        }
    });
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

/// Whose the steps of a unit's matrix are, in their order.
std::vector<MatrixPart> matrixParts(const Scene& scene, const FragmentExplanation& fragment,
                                    std::size_t unit) {
    std::vector<MatrixPart> parts;
    for (const PlacedStep& placed : textureSteps(scene, static_cast<std::size_t>(fragment.pass), unit,
                                                 static_cast<std::size_t>(fragment.model))) {
        const int model = placed.model ? static_cast<int>(*placed.model) : -1;
        if (parts.empty() || parts.back().pass != static_cast<int>(placed.pass) ||
            parts.back().model != model)
            parts.push_back({static_cast<int>(placed.pass), model, 0});
        ++parts.back().steps;
    }
    return parts;
}

void Prober::explainUnits(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                          const std::vector<VertexRecord>& records, const Coords& given,
                          const Coords& embossed) const {
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
        unit.internalFormat = state.texture->internalFormat;
        const Texture& texture = scene_.textures[static_cast<std::size_t>(unit.texture)];
        if (texture.source == SourceKind::Picture)
            unit.picture = texture.picture;
        // What the light sees stays as it is: see texture_levels.h.
        if (texture.source != SourceKind::LightDepth || !isDepth(texture.internalFormat))
            std::ranges::transform(texture.preparation, std::back_inserter(unit.preparation), &ImageStep::op);
        unit.generates = {state.unit->texGenS.enabled, state.unit->texGenT.enabled,
                          state.unit->texGenR.enabled, state.unit->texGenQ.enabled};
        unit.embosses = state.unit->emboss.enabled;
        unit.pixel = {glm::vec4(0), glm::vec4(0), glm::vec4(0), glm::vec4(0)};
        for (std::size_t c = 0; c < records.size(); ++c) {
            const CoordinateSteps steps{given[c][u], embossed[c][u], records[c].generated[u],
                                        records[c].shaded.texCoords[u]};
            const float weight = fragment.vertices[c].weight;
            unit.pixel.given += weight * steps.given;
            unit.pixel.embossed += weight * steps.embossed;
            unit.pixel.generated += weight * steps.generated;
            unit.vertices.push_back(steps);
        }
        unit.matrix = state.matrices[static_cast<std::size_t>(fragment.model)];
        unit.matrixParts = matrixParts(scene_, fragment, u);
        unit.flipped = state.flip == LateFlip::Coordinates;
        const TexturePlace place = texturePlace(cover.triangle, u, offset);
        unit.pixel.transformed = place.homogeneous;
        unit.coords = place.coords;
        unit.derivatives = place.derivatives;
        unit.sampler = static_cast<const SamplerState&>(*state.texture);
        unit.lodBias = state.sampling.unitBias;
        unit.sample = explainSample(*state.texture, place.coords, place.derivatives, state.sampling);
        unit.ties = tiesOf(*state.texture, place.coords, place.derivatives, state.sampling, unit.sample);
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

PixelBytes Prober::bytesRounded(glm::vec4 signs) const {
    Explanation scratch;
    scratch.pixel = explanation_.pixel;
    Prober other(scratch, scene_, viewport_, 0);
    for (const Triangle& drawn : explained_) {
        PassState pass = *drawn.pass;
        Triangle moved = drawn;
        moved.pass = &pass;
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
            UnitState& unit = pass.units[u];
            if (!unit.texture)
                continue;
            unit.sampling = rounded(unit.sampling, signs);
            const glm::vec3 coords = texturePlace(drawn, u, offsetOf(drawn)).coords;
            const glm::vec3 by = rounded(unit.texture->target, coords, signs) - coords;
            Plane<glm::vec4>& plane = moved.texCoords[u]; // s over q is to become s over q + by
            for (glm::vec4* each : {&plane.origin, &plane.dx, &plane.dy})
                *each += glm::vec4(by * each->q, 0);
        }
        FragmentExplanation fragment;
        fragment.color = fragmentColor(moved, offsetOf(moved));
        other.test(fragment, moved);
    }
    return other.bytes();
}

void Prober::explain(FragmentExplanation& fragment, const Cover& cover, const PassState& pass,
                     const std::vector<VertexRecord>& records, const Coords& given,
                     const Coords& embossed) const {
    const Triangle& triangle = cover.triangle;
    const glm::vec2 offset = offsetOf(triangle);
    fragment.lighting = pass.pass->lighting;
    fragment.flat = pass.flat;
    fragment.separateSpecular = pass.separateSpecular;
    fragment.twoSided = pass.twoSided;
    fragment.primary = primaryColor(triangle, offset);
    if (pass.separateSpecular)
        fragment.secondary =
            glm::clamp(triangle.secondary.at(offset) * (1 / triangle.invW.at(offset)), 0.0F, 1.0F);
    explainUnits(fragment, cover, pass, records, given, embossed);
    fragment.summed = summedColor(triangle, offset);
    if (pass.fog) {
        const float distance = fogDistance(triangle, offset);
        fragment.fog = {*pass.fog, distance, fogEquation(*pass.fog, distance),
                        fogFactor(*pass.fog, distance)};
    }
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
        Sentence reason(N_("there is no {0}"), ProperName{name});
        if (unit.texture >= 0 && static_cast<std::size_t>(unit.texture) < scene.textures.size()) {
            std::vector<Sentence> said;
            const StoredTexture* stored = textures.prepare(scene, static_cast<std::size_t>(unit.texture),
                                                           unit.target, images, work, said);
            reason = stored          ? Sentence("{0} is incomplete: {1}", ProperName{name},
                                                checkCompleteness(stored->sampled).reason)
                     : !said.empty() ? said.front()
                                     : Sentence("{0} can't be drawn", ProperName{name});
        }
        idle.push_back({static_cast<int>(u), std::move(reason)});
    }
    return idle;
}

void addIdleUnits(Explanation& explanation, const std::vector<PassState>& passes, const DrawRequest& request,
                  const LevelWork& work, TextureStore& textures) {
    std::vector<std::optional<std::vector<IdleUnit>>> known(passes.size());
    for (FragmentExplanation& fragment : explanation.fragments) {
        const auto pass = static_cast<std::size_t>(fragment.pass);
        if (!known[pass])
            known[pass] = idleUnits(request.scene, passes[pass], request.images, work, textures);
        fragment.idle = *known[pass];
    }
}

/// The memory of custom uploads.
void addUploads(Explanation& explanation, const DrawRequest& request, const LevelWork& work,
                TextureStore& textures) {
    for (FragmentExplanation& fragment : explanation.fragments) {
        for (UnitExplanation& unit : fragment.units) {
            const auto index = static_cast<std::size_t>(unit.texture);
            if (!request.scene.textures[index].upload.custom)
                continue;
            std::vector<Sentence> said; // already
            if (const StoredTexture* stored =
                    textures.prepare(request.scene, index, unit.target, request.images, work, said))
                unit.uploaded = stored->uploaded;
        }
    }
}

/// What ties of any unit depend on. Of a pixel whose first fragments aren't explained it isn't known.
glm::bvec4 tiedInAll(const Explanation& explanation) {
    glm::bvec4 tied(false);
    for (const FragmentExplanation& fragment : explanation.fragments) {
        if (fragment.outcome != FragmentOutcome::FailedDepthTest)
            for (const UnitExplanation& unit : fragment.units)
                tied = glm::bvec4(glm::ivec4(tied) + glm::ivec4(tiedIn(unit.ties.ties, unit.target)));
    }
    return explanation.firstFragment == 0 ? tied : glm::bvec4(false);
}

} // namespace

Result<Explanation> explainPixel(const DrawRequest& request, PixelPlace pixel, const DrawOptions& options,
                                 TextureStore& textures) {
    const Scene& scene = request.scene;
    const Viewport viewport{request.width, request.height, request.cornerBits};
    const auto stopped = [] { return fail(ErrorCode::Cancelled, "the probe was stopped"); };
    Explanation explanation;
    explanation.pixel = pixel;
    explanation.width = viewport.width;
    explanation.height = viewport.height;
    explanation.time = request.time;
    explanation.background = explanation.color = glm::clamp(scene.view.background, 0.0F, 1.0F);
    const std::vector<PassState> passes = passStates(scene, request.images, request.time, options.levels,
                                                     request.sampling(), textures, explanation.problems);
    if (options.isStopped())
        return stopped();
    const glm::mat4 projection = projectionMatrix(scene.view, static_cast<float>(viewport.width) /
                                                                  static_cast<float>(viewport.height));
    const Explanation nothing = explanation;
    std::optional<Prober> prober;
    const auto probeFrom = [&](std::size_t first) {
        explanation = nothing;
        prober.emplace(explanation, scene, viewport, first);
        for (std::size_t p = 0; p < passes.size(); ++p) {
            for (const std::size_t m : drawnModels(scene, scene.passes[p])) {
                if (!options.stop.stop_requested())
                    prober->draw(passes[p], p, m, projection);
            }
        }
    };
    probeFrom(0);
    if (const std::size_t first = prober->firstWanted(); first > 0)
        probeFrom(first);
    if (options.isStopped())
        return stopped();
    explanation.bytes = prober->bytes();
    std::vector<PixelBytes> known{explanation.bytes};
    const glm::bvec4 tied = tiedInAll(explanation);
    for (const glm::vec4& signs : glm::any(tied) ? roundingsOf(tied) : std::vector<glm::vec4>()) {
        const PixelBytes other = prober->bytesRounded(signs);
        if (std::ranges::find(known, other) != known.end())
            continue;
        known.push_back(other);
        explanation.asRight.push_back(other);
    }
    addIdleUnits(explanation, passes, request, options.levels, textures);
    addUploads(explanation, request, options.levels, textures);
    return explanation;
}

Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel, const DrawOptions& options) {
    return ReferenceRenderer().probe(request, pixel, options);
}

} // namespace texplorer::reference

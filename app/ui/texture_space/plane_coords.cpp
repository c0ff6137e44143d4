#include "app/ui/texture_space/plane_coords.h"

#include "texplorer/reference/shading/coordinates.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"
#include "texplorer/texture/late_flip.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

bool generatesAny(const Unit& unit) {
    return unit.texGenS.enabled || unit.texGenT.enabled || unit.texGenR.enabled || unit.texGenQ.enabled;
}

LateFlip flipOfBound(const Session& session, const Unit& unit) {
    const auto image = boundImage(session);
    return image ? lateFlipOf(*boundTexture(session), *image, unit.target) : LateFlip::None;
}

} // namespace

void PlaneCoords::follow(const Session& session) {
    const double time = session.look.playback.time;
    const Scene& scene = presentScene(session);
    const Unit& unit = selectedUnit(session);
    const Model* model = selectedModel(session);
    if (unit.target == Target::CubeMap || !model) {
        *this = {};
        return;
    }
    static_cast<void>(selectedMesh(session)); // makes the mesh of the key
    const auto at = static_cast<std::size_t>(session.look.selection.unit);
    Key key{session.mesh.mesh, model->texCoords[at], model->noTexCoord[at], unit, flipOfBound(session, unit)};
    const Selection& selection = session.look.selection;
    key.matrix = reference::coordinateMatrix(scene, static_cast<std::size_t>(selection.pass),
                                             static_cast<std::size_t>(selection.unit),
                                             static_cast<std::size_t>(selection.model), key.flip, time);
    if (generatesAny(unit) || unit.emboss.enabled)
        key.modelview = modelViewMatrix(scene.view, *model, time);
    if (unit.emboss.enabled)
        key.light = lightInModel(scene, *model, unit.emboss.carrier, time);
    if (key == key_)
        return;
    key_ = std::move(key);
    makePlaces(session, scene, *model);
}

void PlaneCoords::makePlaces(const Session& session, const Scene& scene, const Model& model) {
    const Selection& selection = session.look.selection;
    const Pass& pass = scene.passes[static_cast<std::size_t>(selection.pass)];
    const Mesh& mesh = *key_.mesh;
    given_ = effectiveTexCoords(model, mesh, selection.unit);
    relief_.clear();
    if (key_.unit.emboss.enabled) {
        relief_ = givenTexCoords(scene, pass, selection.unit, model, mesh, session.look.playback.time);
        std::ranges::transform(relief_, given_, relief_.begin(), std::minus<>());
    }
    // A picture that is upside down in the texture is shown upright, and its samples are moved with it.
    shown_ = key_.flip == LateFlip::None ? key_.matrix : reference::upsideDown() * key_.matrix;
    const reference::EyeSpace eye(key_.modelview);
    sources_ = coordSources(model, mesh, selection.unit);
    const std::size_t count = given_.size();
    generated_.resize(count);
    givenPlaces_.resize(count);
    resultingPlaces_.resize(count);
    differ_ = false;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec4 moved = relief_.empty() ? current(i) : current(i) + relief_[i];
        generated_[i] = generatedFrom(moved, eye, mesh.vertices[i]);
        const glm::vec4 end = shown_ * generated_[i];
        givenPlaces_[i] = glm::vec2(current(i));
        resultingPlaces_[i] = glm::vec2(end) / end.q;
        constexpr float alike = 1e-6F; // the rounding of a flip and its inverse
        const auto isElsewhere = [](float a, float b) {
            return !(std::abs(a - b) <= alike * std::max(1.0F, std::abs(a)));
        };
        differ_ = differ_ || isElsewhere(givenPlaces_[i].x, resultingPlaces_[i].x) ||
                  isElsewhere(givenPlaces_[i].y, resultingPlaces_[i].y);
    }
    makeOutlines(session, scene, model);
}

glm::vec4 PlaneCoords::current(std::size_t vertex) const {
    return sources_[vertex] ? given_[*sources_[vertex]] : glm::vec4(0, 0, 0, 1);
}

Result<void> PlaneCoords::hasOwn(std::size_t vertex) const {
    if (sources_[vertex] == vertex)
        return {};
    return fail(ErrorCode::Unsupported,
                Sentence("glTexCoord of vertex {0} is left out: its coordinate has no effect", vertex));
}

void PlaneCoords::makeOutlines(const Session& session, const Scene& scene, const Model& model) {
    const Selection& selection = session.look.selection;
    sent_.reset();
    if (!leavesOutCalls(model))
        return;
    const SentModel drawn(model);
    Mesh mesh = meshOf(*drawn);
    const auto alike = [](const Face& a, const Face& b) { return a.vertices.size() == b.vertices.size(); };
    if (!std::ranges::equal(mesh.faces, key_.mesh->faces, alike))
        return; // a round shape, whose faces are no parts of its primitive
    sentPlaces_.clear();
    const reference::EyeSpace eye(key_.modelview);
    const TexCoords coords = givenTexCoords(scene, scene.passes[static_cast<std::size_t>(selection.pass)],
                                            selection.unit, *drawn, mesh, session.look.playback.time);
    for (std::size_t i = 0; i < coords.size(); ++i) {
        const glm::vec4 end = shown_ * generatedFrom(coords[i], eye, mesh.vertices[i]);
        sentPlaces_.push_back(glm::vec2(end) / end.q);
    }
    sent_ = std::move(mesh);
}

glm::vec4 PlaneCoords::generatedFrom(glm::vec4 moved, const reference::EyeSpace& eye,
                                     const Vertex& vertex) const {
    return reference::generatedCoordinates(key_.unit, key_.flip, moved, eye(vertex));
}

Result<glm::vec4> PlaneCoords::givenFor(std::size_t vertex, glm::vec2 place) const {
    const std::array<const TexGen*, 2> generation{&key_.unit.texGenS, &key_.unit.texGenT};
    constexpr std::array names{"s", "t"};
    for (std::size_t i = 0; i < generation.size(); ++i) {
        if (generation[i]->enabled)
            return fail(ErrorCode::Unsupported,
                        Sentence("{0} is generated ({1}): the given coordinate has no effect", names[i],
                                 rowOf(generation[i]->mode).name));
    }
    if (const Result<void> own = hasOwn(vertex); !own)
        return fail(own.error());
    // (x - place.x w, y - place.y w) = 0, which is linear in s and t.
    const auto coefficient = [&](int column) {
        return glm::dvec2(shown_[column]) - glm::dvec2(place) * double{shown_[column].w};
    };
    const glm::vec4& known = generated_[vertex];
    const glm::dvec2 s = coefficient(0);
    const glm::dvec2 t = coefficient(1);
    const glm::dvec2 rest = -(coefficient(2) * double{known.r} + coefficient(3) * double{known.q});
    const double determinant = s.x * t.y - s.y * t.x;
    const double scale = std::max({std::abs(s.x), std::abs(s.y), std::abs(t.x), std::abs(t.y)});
    if (!(std::abs(determinant) > 1e-9 * scale * scale))
        return fail(ErrorCode::Unsupported,
                    "the texture matrix has no inverse: it maps many coordinates to one place");
    glm::vec4 given = given_[vertex];
    given.s = static_cast<float>((rest.x * t.y - rest.y * t.x) / determinant);
    given.t = static_cast<float>((s.x * rest.y - s.y * rest.x) / determinant);
    if (key_.flip == LateFlip::Coordinates)
        given.t = given.q - given.t;
    if (!relief_.empty()) {
        given.s -= relief_[vertex].s;
        given.t -= relief_[vertex].t;
    }
    if (!std::isfinite(given.s) || !std::isfinite(given.t))
        return fail(ErrorCode::OutOfRange, "no finite coordinate maps there");
    return given;
}

} // namespace texplorer::ui

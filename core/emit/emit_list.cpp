// Display lists: what stands between glBegin and glEnd, compiled once.

#include "texplorer/emit/model_arrays.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::emit {
namespace {

class ListWriter {
public:
    ListWriter(Emission& emission, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , model_(emission.scene.models[index])
        , form_(emission.models[index])
        , index_(index)
        , mesh_(meshOf(model_)) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            flips_[u] = emission.flipsCoords(index, u);
            if (form_.coords[u])
                coords_[u] = effectiveTexCoords(model_, mesh_, static_cast<int>(u));
            for (glm::vec4& coord : coords_[u])
                coord.t = flips_[u] ? coord.q - coord.t : coord.t;
        }
    }

    void write() {
        const std::string variable = fmt::format("model{}", index_);
        writer_.add(fmt::format("{} = glGenLists(1);", variable));
        writer_.add({call("glNewList"),
                     plain(fmt::format("({}, GL_COMPILE); ", variable)),
                     {Part::Kind::Comment, fmt::format("/* {} */", inComment(nameOf(model_)))}});
        const std::vector<SentVertex> sent = sentVertices(model_, mesh_);
        for (std::size_t u = 0; u < maxUnits && !sent.empty(); ++u) {
            if (form_.coords[u] && !sent.front().coordsOf[u])
                writeFirstCoords(u);
        }
        writer_.add({call("glBegin"), plain("("), primitivePart(model_, index_), plain(");")});
        std::optional<glm::vec3> normal;
        for (const SentVertex& each : sent) {
            const std::size_t i = each.vertex;
            const Vertex& vertex = mesh_.vertices[i];
            writeFace(i);
            if (emission_.needsNormals && normal != normalOf(i)) {
                normal = normalOf(i);
                writer_.add(callWith("glNormal3f",
                                     numbers({&normal->x, 3}, meshPath<&MeshData::normals>(i, *normal))));
            }
            if (mesh_.colored)
                writer_.add(callWith("glColor4f", numbers({&vertex.color.x, 4},
                                                          meshPath<&MeshData::colors>(i, vertex.color))));
            writeVertex(each);
        }
        writer_.add("glEnd();");
        writer_.add("glEndList();");
    }

private:
    /// What is current where glTexCoord of the first vertices is left out.
    void writeFirstCoords(std::size_t unit) {
        const glm::vec4 first(0, flips_[unit] ? 1 : 0, 0, 1);
        std::vector<Part> parts = coordCall(unit, first, {});
        parts.push_back(plain(" "));
        parts.push_back({Part::Kind::Comment, "/* until a vertex has its own */"});
        writer_.add(std::move(parts));
    }

    /// "glTexCoord2f(1.0f, 0.0f);", or glMultiTexCoord where several units take coordinates.
    [[nodiscard]] std::vector<Part> coordCall(std::size_t unit, const glm::vec4& coord,
                                              const std::string& path) const {
        const int count = coordCount(coords_[unit]);
        const bool isOne =
            std::none_of(form_.coords.begin() + 1, form_.coords.end(), [](bool on) { return on; });
        std::vector<Part> arguments;
        if (!isOne)
            arguments.push_back(plain(fmt::format("{}, ", textureUnitName(unit))));
        append(arguments, numbers(firstOf(coord, count), path));
        return callWith(fmt::format("{}{}f", isOne ? "glTexCoord" : "glMultiTexCoord", count),
                        std::move(arguments));
    }

    /// As the scene has it, of any length: GL_NORMALIZE is on.
    [[nodiscard]] glm::vec3 normalOf(std::size_t vertex) const {
        const auto& normals = model_.mesh.normals;
        return model_.shape == Shape::Mesh && normals.size() == mesh_.vertices.size()
                   ? normals[vertex]
                   : mesh_.vertices[vertex].normal;
    }

    [[nodiscard]] std::string own(std::string_view key) const {
        return fmt::format("{}.{}", elementOf<&Scene::models>(index_), key);
    }

    /// The parameter that a vertex has a value from; empty: none.
    template<auto List>
    [[nodiscard]] std::string meshPath(std::size_t vertex, const auto& value) const {
        const auto& rows = model_.mesh.*List;
        if (model_.shape != Shape::Mesh || vertex >= rows.size() || rows[vertex] != value)
            return {};
        return own(fmt::format("{}.{}[{}]", keyOf<&Model::mesh>(), keyOf<List>(), vertex));
    }

    /// Which face begins with a vertex, of a shape that has several.
    void writeFace(std::size_t vertex) {
        if (model_.shape == Shape::Mesh || hasIndices(model_) || mesh_.faces.size() < 2)
            return;
        for (const Face& face : mesh_.faces) {
            if (face.vertices.front() == vertex)
                writer_.comment(face.name);
        }
    }

    /// Its coordinates, unless their call is left out, and its place, on one line.
    void writeVertex(const SentVertex& sent) {
        const std::size_t vertex = sent.vertex;
        std::vector<Part> parts;
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (coords_[u].empty() || sent.coordsOf[u] != sent.vertex)
                continue;
            append(parts,
                   coordCall(u, coords_[u][vertex],
                             flips_[u] ? std::string()
                                       : own(fmt::format("{}[{}]", findKey(memberId<&Model::texCoords>, u),
                                                         vertex))));
            parts.push_back(plain(" "));
        }
        const glm::vec3& position = mesh_.vertices[vertex].position;
        append(parts, callWith("glVertex3f",
                               numbers({&position.x, 3}, meshPath<&MeshData::positions>(vertex, position))));
        writer_.add(std::move(parts));
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    const ModelForm& form_;
    std::size_t index_;
    Mesh mesh_;
    std::array<bool, maxUnits> flips_{};
    std::array<TexCoords, maxUnits>
        coords_{}; ///< of the units that take them, turned around as the images are
};

} // namespace

Part primitivePart(const Model& model, std::size_t index) {
    std::string name(rowOf(sentPrimitive(model)).name);
    return model.shape == Shape::Mesh
               ? choice(name, fmt::format("{}.{}.{}", elementOf<&Scene::models>(index), keyOf<&Model::mesh>(),
                                          keyOf<&MeshData::primitive>()))
               : plain(std::move(name));
}

void writeList(Emission& emission, std::size_t model) {
    ListWriter(emission, model).write();
}

} // namespace texplorer::emit

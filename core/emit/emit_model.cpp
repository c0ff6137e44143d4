#include "core/emit/emission.h"
#include "core/gl/argument_names.h"
#include "core/scene/animation.h"
#include "core/scene/drawn_models.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/keys.h"
#include "core/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

std::string coordsPath(std::size_t model, std::size_t unit) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(model), findKey(memberId<&Model::texCoords>, unit));
}

/// How many of s, t, r and q have to be given: two at least.
int coordCount(const TexCoords& coords) {
    int count = 2;
    for (const glm::vec4 each : coords)
        count = std::max(count, each.w != 1 ? 4 : each.z != 0 ? 3 : 2);
    return count;
}

std::span<const float> firstOf(const glm::vec4& coord, int count) {
    return {&coord.x, static_cast<std::size_t>(count)};
}

glm::vec3 normalOf(const Vertex& vertex) {
    return vertex.normal == glm::vec3(0) ? glm::vec3(0, 0, 1) : vertex.normal; // as glNormal begins
}

class ModelWriter {
public:
    ModelWriter(Emission& emission, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , model_(emission.scene.models[index])
        , form_(emission.models[index])
        , index_(index)
        , path_(elementOf<&Scene::models>(index))
        , variable_(fmt::format("model{}", index)) {
        if (form_.drawing == Drawing::Vertices || form_.isWritten)
            mesh_ = meshOf(model_);
    }

    void declare() {
        if (form_.drawing != Drawing::Arrays)
            return;
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        table("Positions", 3,
              [](const Vertex& vertex, std::size_t) { return glm::vec4(vertex.position, 0); });
        if (emission_.needsNormals)
            table("Normals", 3,
                  [](const Vertex& vertex, std::size_t) { return glm::vec4(normalOf(vertex), 0); });
        if (isColored())
            table("Colors", 4, [](const Vertex& vertex, std::size_t) { return vertex.color; });
        for (std::size_t u = 0; u < maxUnits; ++u) {
            declareCoords(u);
        }
        if (hasIndices(model_))
            declareIndices();
    }

    void draw(const Pass& pass) {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        writer_.add("glPushMatrix();");
        place();
        writeMaterial(emission_, index_);
        switch (form_.drawing) {
        case Drawing::Quadric:
            drawQuadric();
            break;
        case Drawing::Vertices:
            drawVertices();
            break;
        case Drawing::Arrays:
            drawArrays(pass);
            break;
        case Drawing::None:
            break;
        }
        if (isColored()) // glColor is the last vertex's
            writer_.forget(fmt::format("{}.{}", keyOf<&Scene::material>(), keyOf<&Material::color>()));
        writer_.add("glPopMatrix();");
    }

private:
    [[nodiscard]] std::string own(std::string_view key) const { return fmt::format("{}.{}", path_, key); }
    [[nodiscard]] bool isColored() const {
        return model_.shape == Shape::Mesh && !model_.mesh.colors.empty();
    }

    /// An array with a row for each vertex, or its name alone.
    template<class Get>
    void table(std::string_view name, int count, Get get, const std::string& path = {}) {
        const std::string declared = fmt::format("GLfloat {}{}[][{}]", variable_, name, count);
        if (!form_.isWritten)
            return writer_.add(fmt::format("extern const {};", declared));
        writer_.add(fmt::format("const {} = {{", declared));
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const glm::vec4 values = get(mesh_.vertices[i], i);
            std::vector<Part> parts{plain("    {")};
            append(parts,
                   numbers(firstOf(values, count), path.empty() ? path : fmt::format("{}[{}]", path, i)));
            parts.push_back(plain("},"));
            writer_.add(std::move(parts));
        }
        writer_.add("};");
    }

    void declareCoords(std::size_t unit) {
        const std::string name = coordsName(unit, false);
        if (form_.coords[unit] && form_.isWritten) {
            const TexCoords coords = effectiveTexCoords(model_, mesh_, static_cast<int>(unit));
            table(
                name, coordCount(coords), [&](const Vertex&, std::size_t i) { return coords[i]; },
                coordsPath(index_, unit));
        } else if (form_.coords[unit]) {
            writer_.add(fmt::format("extern const GLfloat {}{}[][4];", variable_, name));
        }
        if (form_.embossed[unit])
            writer_.add(
                {plain(fmt::format("extern GLfloat {}{}[][4]; ", variable_, coordsName(unit, true))),
                 {Part::Kind::Comment, "/* in every frame moved towards the light, vertex by vertex */"}});
    }

    static std::string coordsName(std::size_t unit, bool isEmbossed) {
        return fmt::format("{}{}", isEmbossed ? "EmbossedCoords" : "TexCoords", unit);
    }

    [[nodiscard]] int coordComponents(std::size_t unit, bool isEmbossed) const {
        if (!form_.isWritten || isEmbossed)
            return 4;
        return coordCount(effectiveTexCoords(model_, mesh_, static_cast<int>(unit)));
    }

    void declareIndices() {
        if (!form_.isWritten) {
            writer_.add(fmt::format("extern const GLuint {0}Indices[]; extern const GLsizei {0}IndexCount;",
                                    variable_));
            return;
        }
        std::string list;
        for (const int each : validIndices())
            list += fmt::format("{}{}", list.empty() ? "" : ", ", each);
        writer_.add(fmt::format("const GLuint {}Indices[] = {{{}}};", variable_, list));
    }

    /// Those that name a vertex: the others are left out.
    [[nodiscard]] std::vector<int> validIndices() const {
        std::vector<int> indices = model_.mesh.indices;
        std::erase_if(indices, [&](int each) {
            return each < 0 || static_cast<std::size_t>(each) >= mesh_.vertices.size();
        });
        if (indices.empty())
            indices.push_back(0); // C has no empty array
        return indices;
    }

    void place() {
        if (model_.attachment == Attachment::Eye)
            writer_.add("glLoadIdentity();");
        writer_.add(
            callWith("glTranslatef", numbers({&model_.position.x, 3}, own(keyOf<&Model::position>()))),
            model_.position != glm::vec3(0));
        constexpr std::array axes{", 1.0f, 0.0f, 0.0f", ", 0.0f, 1.0f, 0.0f", ", 0.0f, 0.0f, 1.0f"};
        for (const int axis : rotationAxes(model_.rotationOrder)) {
            const bool spins = model_.spin[axis] != 0;
            std::vector<Part> arguments =
                moving(writer_, number(model_.rotation[axis], own(keyOf<&Model::rotation>()), axis),
                       number(model_.spin[axis], own(keyOf<&Model::spin>()), axis), spins);
            arguments.push_back(plain(axes.at(static_cast<std::size_t>(axis))));
            writer_.add(callWith("glRotatef", std::move(arguments)), spins || model_.rotation[axis] != 0);
        }
        const Part size = number(model_.size, own(keyOf<&Model::size>()));
        writer_.add(callWith("glScalef", {size, plain(", "), size, plain(", "), size}), model_.size != 1);
        writer_.add(callWith("glScalef", numbers({&model_.scale.x, 3}, own(keyOf<&Model::scale>()))),
                    model_.scale != glm::vec3(1));
    }

    void drawQuadric() {
        const auto number64 = [&](float value, const std::string& key) {
            return number(value, own(key), -1, Literal::Double);
        };
        const Part slices = whole(model_.slices, own(keyOf<&Model::slices>()));
        const Part stacks = whole(model_.stacks, own(keyOf<&Model::stacks>()));
        const Part comma = plain(", ");
        const bool stands = model_.shape == Shape::Sphere || model_.shape == Shape::Cylinder;
        if (stands)
            writer_.add("glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);"); // GLU's shapes stand along z; ours along y
        const Part inner = number64(model_.innerRadius, keyOf<&Model::innerRadius>());
        switch (model_.shape) {
        case Shape::Sphere:
            return writer_.add(callWith("gluSphere", {plain("quadric, 1.0, "), slices, comma, stacks}));
        case Shape::Cylinder:
            writer_.add("glTranslatef(0.0f, 0.0f, -1.0f);");
            return writer_.add(
                callWith("gluCylinder",
                         {plain("quadric, 1.0, "), number64(model_.topRadius, keyOf<&Model::topRadius>()),
                          plain(", 2.0, "), slices, comma, stacks}));
        case Shape::Disk:
            return writer_.add(
                callWith("gluDisk", {plain("quadric, "), inner, plain(", 1.0, "), slices, comma, stacks}));
        default:
            return writer_.add(callWith("gluPartialDisk",
                                        {plain("quadric, "), inner, plain(", 1.0, "), slices, comma, stacks,
                                         comma, number64(model_.startAngle, keyOf<&Model::startAngle>()),
                                         comma, number64(model_.sweepAngle, keyOf<&Model::sweepAngle>())}));
        }
    }

    /// The size of lines and points, where there are any.
    void writeSize() {
        static const Model initial;
        const Holder holder{modelTable(), &model_, &initial, path_, "model", variable_};
        const int corners = partCorners(model_);
        if (corners == 2)
            writer_.row(holder, memberId<&Model::lineWidth>);
        if (corners == 1)
            writer_.row(holder, memberId<&Model::pointSize>);
    }

    void drawVertices() {
        writeSize();
        writer_.add({call("glBegin"), plain("("), primitivePart(), plain(");")});
        std::array<TexCoords, maxUnits> coords;
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (form_.coords[u])
                coords[u] = effectiveTexCoords(model_, mesh_, static_cast<int>(u));
        }
        std::optional<glm::vec3> normal;
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const Vertex& vertex = mesh_.vertices[i];
            if (emission_.needsNormals && normal != normalOf(vertex)) {
                normal = normalOf(vertex);
                addIndented(callWith("glNormal3f", numbers({&normal->x, 3})));
            }
            if (isColored())
                addIndented(callWith("glColor4f", numbers({&vertex.color.x, 4})));
            drawVertex(coords, i);
        }
        writer_.add("glEnd();");
    }

    void addIndented(std::vector<Part> parts) {
        parts.insert(parts.begin(), plain("    "));
        writer_.add(std::move(parts));
    }

    [[nodiscard]] Part primitivePart() const {
        return model_.shape == Shape::Mesh
                   ? choice(primitiveOf(model_),
                            own(fmt::format("{}.{}", keyOf<&Model::mesh>(), keyOf<&MeshData::primitive>())))
                   : plain(primitiveOf(model_));
    }

    /// Its coordinates and its place, on one line.
    void drawVertex(const std::array<TexCoords, maxUnits>& coords, std::size_t vertex) {
        std::vector<Part> parts{plain("    ")};
        const bool isOne =
            std::none_of(form_.coords.begin() + 1, form_.coords.end(), [](bool on) { return on; });
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (coords[u].empty())
                continue;
            const int count = coordCount(coords[u]);
            const std::string path = fmt::format("{}[{}]", coordsPath(index_, u), vertex);
            std::vector<Part> arguments;
            if (!isOne)
                arguments.push_back(plain(fmt::format("{}, ", textureUnitName(u))));
            append(arguments, numbers(firstOf(coords[u][vertex], count), path));
            append(parts, callWith(fmt::format("{}{}f", isOne ? "glTexCoord" : "glMultiTexCoord", count),
                                   std::move(arguments)));
            parts.push_back(plain(" "));
        }
        append(parts, callWith("glVertex3f", numbers({&mesh_.vertices[vertex].position.x, 3})));
        writer_.add(std::move(parts));
    }

    void drawArrays(const Pass& pass) {
        writeSize();
        writer_.add("glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);");
        point(vertexArray, "glVertexPointer(3, ", "Positions");
        if (emission_.needsNormals)
            point(normalArray, "glNormalPointer(", "Normals");
        if (isColored())
            point(colorArray, "glColorPointer(4, ", "Colors");
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& unit = pass.units[u];
            if (!takesCoords(unit))
                continue;
            writer_.add(fmt::format("glClientActiveTexture({});", textureUnitName(u)));
            point(texCoordArray,
                  fmt::format("glTexCoordPointer({}, ", coordComponents(u, unit.emboss.enabled)),
                  coordsName(u, unit.emboss.enabled));
        }
        if (hasIndices(model_)) {
            const std::string count = form_.isWritten ? fmt::format("{}", validIndices().size())
                                                      : fmt::format("{}IndexCount", variable_);
            writer_.add({call("glDrawElements"), plain("("), primitivePart(),
                         plain(fmt::format(", {}, {}, {}Indices);", count, unsignedIntType, variable_))});
        } else {
            writer_.add({call("glDrawArrays"), plain("("), primitivePart(),
                         plain(fmt::format(", 0, {});", vertexCountOf(model_)))});
        }
        writer_.add("glPopClientAttrib();");
    }

    void point(std::string_view array, const std::string& function, std::string_view name) {
        writer_.add(fmt::format("glEnableClientState({});", array));
        writer_.add(fmt::format("{}{}, 0, {}{});", function, floatType, variable_, name));
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    const ModelForm& form_;
    std::size_t index_;
    std::string path_;
    std::string variable_;
    Mesh mesh_; ///< where its numbers are written
};

} // namespace

void writeModelData(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).declare();
}

void writeModel(Emission& emission, std::size_t pass, std::size_t model) {
    ModelWriter(emission, model).draw(emission.scene.passes[pass]);
}

} // namespace texplorer::emit

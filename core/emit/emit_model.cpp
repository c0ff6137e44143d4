#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

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
        , sent_(model_)
        , form_(emission.models[index])
        , index_(index)
        , path_(elementOf<&Scene::models>(index))
        , variable_(fmt::format("model{}", index))
        , isTwisted_(isTwisted(model_)) {
        if (form_.drawing == Drawing::List || form_.drawing == Drawing::Arrays)
            mesh_ = meshOf(geometry());
    }

    void declare() {
        switch (form_.drawing) {
        case Drawing::None:
        case Drawing::Quadric:
            break;
        case Drawing::Shape:
            emission_.atStart.add({plain(fmt::format("static Mesh {}; ", variable_)), nameComment()});
            emission_.use(CFunction::MeshTypes);
            break;
        case Drawing::List:
            emission_.atStart.add({plain(fmt::format("static GLuint {}; ", variable_)), nameComment()});
            break;
        case Drawing::Arrays:
            declareArrays();
            break;
        }
    }

    /// "sphere(32, 16)"
    [[nodiscard]] std::vector<Part> shapeCall() {
        const Part slices = whole(model_.slices, own(keyOf<&Model::slices>()));
        const Part stacks = whole(model_.stacks, own(keyOf<&Model::stacks>()));
        const Part comma = plain(", ");
        std::vector<Part> parts;
        switch (model_.shape) {
        case Shape::Sphere:
            emission_.use(CFunction::Sphere);
            append(parts, {plain("sphere("), slices, comma, stacks});
            break;
        case Shape::Cylinder:
            emission_.use(CFunction::Cylinder);
            append(parts, {plain("cylinder("), floatPart(model_.topRadius, keyOf<&Model::topRadius>()), comma,
                           slices, comma, stacks});
            break;
        case Shape::Torus:
            emission_.use(CFunction::Torus);
            // Fewer than a triangle around the tube there aren't (core/mesh/mesh.h).
            append(parts,
                   {plain("torus("), floatPart(model_.tubeRadius, keyOf<&Model::tubeRadius>()), comma, slices,
                    comma, model_.stacks < minSlices ? plain(std::to_string(minSlices)) : stacks});
            break;
        default:
            emission_.use(CFunction::Disk);
            append(parts, {plain("disk("), floatPart(model_.innerRadius, keyOf<&Model::innerRadius>()), comma,
                           slices, comma, stacks, comma});
            append(parts, sector());
            break;
        }
        parts.push_back(plain(")"));
        return parts;
    }

    void setUp() {
        if (form_.drawing == Drawing::Shape)
            makeShape();
        if (form_.drawing == Drawing::List)
            compileList();
    }

    void drawShape() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        writer_.add("glPushMatrix();", movesMatrix());
        place(false);
        const auto sized = [&](const std::string& stride, const std::string& vertices) {
            writer_.add("glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);");
            writer_.add(fmt::format("glEnableClientState({});", vertexArray));
            writer_.add(fmt::format("glVertexPointer(3, {}, {}, {});", floatType, stride, vertices));
        };
        switch (form_.drawing) {
        case Drawing::None:
            break;
        case Drawing::Quadric:
            writeQuadric(emission_, index_);
            break;
        case Drawing::List:
            writer_.add(fmt::format("glCallList({});", variable_));
            break;
        case Drawing::Shape:
            sized("sizeof(Vertex)", variable_ + ".vertices->position");
            drawElements();
            break;
        case Drawing::Arrays:
            sized("0", variable_ + "Positions");
            drawElements();
            break;
        }
        writer_.add("glPopMatrix();", movesMatrix());
    }

    void draw(const Pass& pass) {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        const auto passIndex = static_cast<std::size_t>(&pass - emission_.scene.passes.data());
        writeModelMatrices(emission_, passIndex, index_);
        writer_.add("glPushMatrix();", movesMatrix());
        place();
        writeMaterial(emission_, index_);
        switch (form_.drawing) {
        case Drawing::None:
            break;
        case Drawing::List:
            writeSize();
            writer_.add(fmt::format("glCallList({});", variable_));
            break;
        case Drawing::Quadric:
            writeQuadric(emission_, index_);
            break;
        case Drawing::Shape:
            drawShape(pass);
            break;
        case Drawing::Arrays:
            drawArrays(pass);
            break;
        }
        if (isColored()) // glColor is the last vertex's
            writer_.forget(fmt::format("{}.{}", keyOf<&Scene::material>(), keyOf<&Material::color>()));
        writer_.add("glPopMatrix();", movesMatrix());
        endModelMatrices(emission_);
    }

private:
    [[nodiscard]] std::string own(std::string_view key) const { return fmt::format("{}.{}", path_, key); }
    /// Whose vertices mesh_ has: arrays have one for each that is sent, with its coordinates.
    [[nodiscard]] const Model& geometry() const { return form_.drawing == Drawing::List ? model_ : *sent_; }
    [[nodiscard]] bool isColored() const {
        return model_.shape == Shape::Mesh && !model_.mesh.colors.empty();
    }
    [[nodiscard]] Part nameComment() const {
        return {Part::Kind::Comment, fmt::format("/* {} */", inComment(nameOf(model_)))};
    }

    /// A unit's, turned around where its texture lies upside down.
    [[nodiscard]] TexCoords coordsOf(std::size_t unit) const {
        TexCoords coords = effectiveTexCoords(geometry(), mesh_, static_cast<int>(unit));
        if (emission_.flipsCoords(index_, unit)) {
            for (glm::vec4& coord : coords)
                coord.t = coord.q - coord.t;
        }
        return coords;
    }

    void declareArrays() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        if (leavesOutCalls(model_))
            writer_.comment("a vertex without glTexCoord has the coordinates of the one before it");
        table("Positions", 3,
              [](const Vertex& vertex, std::size_t) { return glm::vec4(vertex.position, 0); });
        if (emission_.needsNormals)
            table("Normals", 3,
                  [](const Vertex& vertex, std::size_t) { return glm::vec4(normalOf(vertex), 0); });
        if (isColored())
            table("Colors", 4, [](const Vertex& vertex, std::size_t) { return vertex.color; });
        for (std::size_t u = 0; u < maxUnits; ++u)
            declareCoords(u);
        if (drawsByIndices())
            declareIndices();
    }

    /// An array with a row for each vertex.
    template<class Get>
    void table(const std::string& name, int count, Get get, const std::string& path = {}) {
        if (!form_.isWritten) {
            std::vector<float> values;
            for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
                const glm::vec4 each = get(mesh_.vertices[i], i);
                values.insert(values.end(), &each.x, &each.x + count);
            }
            const std::size_t columns = static_cast<std::size_t>(count) * 2;
            const std::size_t all = values.size();
            return emission_.addData(
                "GLfloat", variable_ + name, all,
                Numbers{[values = std::move(values), columns] { return floatsText(values, columns); }});
        }
        writer_.add(fmt::format("static const GLfloat {}{}[] = {{", variable_, name));
        writer_.indent();
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const glm::vec4 values = get(mesh_.vertices[i], i);
            std::vector<Part> parts =
                numbers(firstOf(values, count), path.empty() ? path : fmt::format("{}[{}]", path, i));
            parts.push_back(plain(","));
            writer_.add(std::move(parts));
        }
        writer_.outdent();
        writer_.add("};");
    }

    void declareCoords(std::size_t unit) {
        if (form_.coords[unit]) {
            const TexCoords coords = coordsOf(unit);
            table(
                coordsName(unit), form_.isWritten ? coordCount(coords) : 4,
                [&](const Vertex&, std::size_t i) { return coords[i]; },
                emission_.flipsCoords(index_, unit) || leavesOutCalls(model_) ? std::string()
                                                                              : coordsPath(index_, unit));
        }
        if (!form_.embossed[unit])
            return;
        const TexCoords coords = effectiveTexCoords(geometry(), mesh_, static_cast<int>(unit));
        table(fmt::format("GivenCoords{}", unit), 4, [&](const Vertex&, std::size_t i) { return coords[i]; });
        const std::vector<Tangents> tangents = tangentsOf(mesh_, coords);
        std::vector<float> values;
        for (const Tangents& each : tangents) {
            values.insert(values.end(), &each.s.x, &each.s.x + 3);
            values.insert(values.end(), &each.t.x, &each.t.x + 3);
        }
        const std::size_t count = values.size();
        emission_.addData("GLfloat", fmt::format("{}Tangents{}", variable_, unit), count,
                          Numbers{[values = std::move(values)] { return floatsText(values, 6); }});
        emission_.atStart.add({plain(fmt::format("static GLfloat {}EmbossedCoords{}[{}]; ", variable_, unit,
                                                 4 * mesh_.vertices.size())),
                               {Part::Kind::Comment, "/* in every frame moved towards the light */"}});
        emission_.use(CFunction::LightInModel);
        emission_.use(CFunction::Emboss);
    }

    static std::string coordsName(std::size_t unit) { return fmt::format("TexCoords{}", unit); }

    [[nodiscard]] int coordComponents(std::size_t unit) const {
        return form_.isWritten ? coordCount(coordsOf(unit)) : 4;
    }

    void declareIndices() {
        std::vector<std::uint32_t> indices = indicesOf();
        if (!form_.isWritten) {
            const std::size_t count = indices.size();
            return emission_.addData(
                "GLuint", variable_ + "Indices", count,
                Numbers{[indices = std::move(indices)] { return indicesText(indices); }});
        }
        std::string list;
        for (const std::uint32_t each : indices)
            list += fmt::format("{}{}", list.empty() ? "" : ", ", each);
        writer_.add(fmt::format("static const GLuint {}Indices[] = {{{}}};", variable_, list));
    }

    /// Mesa divides the quadrilaterals of arrays without indices the other way (core/mesh/mesh.h).
    [[nodiscard]] bool drawsByIndices() const {
        const Model& model = geometry();
        return hasIndices(model) || model.shape != Shape::Mesh || model.mesh.primitive == Primitive::Quads ||
               model.mesh.primitive == Primitive::QuadStrip;
    }

    /// Of a mesh those that name a vertex, in its order: the others are left out. Of a shape its triangles.
    [[nodiscard]] std::vector<std::uint32_t> indicesOf() const {
        std::vector<std::uint32_t> indices = mesh_.triangles;
        if (geometry().shape == Shape::Mesh && !isTwisted_)
            indices = drawnOrder(geometry().mesh);
        if (indices.empty())
            indices.push_back(0); // C has no empty array
        return indices;
    }

    /// Whether it lies elsewhere than where its vertices say, at least at times.
    [[nodiscard]] bool isPlaced() const {
        const std::array keys{&keyOf<&Model::position>(), &keyOf<&Model::rotation>(), &keyOf<&Model::spin>(),
                              &keyOf<&Model::size>(), &keyOf<&Model::scale>()};
        const auto moves = [this](const std::string* key) { return writer_.moves(own(*key)); };
        return std::ranges::any_of(keys, moves) || model_.attachment == Attachment::Eye ||
               model_.position != glm::vec3(0) || model_.rotation != glm::vec3(0) ||
               model_.spin != glm::vec3(0) || model_.size != 1 || model_.scale != glm::vec3(1);
    }

    /// Whether what follows must not see its matrix.
    [[nodiscard]] bool movesMatrix() const {
        return isPlaced() || (form_.drawing == Drawing::Quadric && isTurnedForGlu(model_));
    }

    void place(bool beforeTheEye = true) {
        if (model_.attachment == Attachment::Eye && beforeTheEye)
            writer_.add("glLoadIdentity();");
        writer_.add(
            callWith("glTranslatef", numbers({&model_.position.x, 3}, own(keyOf<&Model::position>()))),
            model_.position != glm::vec3(0));
        constexpr std::array axes{", 1.0f, 0.0f, 0.0f", ", 0.0f, 1.0f, 0.0f", ", 0.0f, 0.0f, 1.0f"};
        for (const int axis : rotationAxes(model_.rotationOrder)) {
            const bool spins = model_.spin[axis] != 0 || writer_.moves(own(keyOf<&Model::spin>()));
            std::vector<Part> arguments =
                turning(writer_, number(model_.rotation[axis], own(keyOf<&Model::rotation>()), axis),
                        number(model_.spin[axis], own(keyOf<&Model::spin>()), axis), spins);
            arguments.push_back(plain(axes.at(static_cast<std::size_t>(axis))));
            writer_.add(callWith("glRotatef", std::move(arguments)), spins || model_.rotation[axis] != 0);
        }
        const Part size = number(model_.size, own(keyOf<&Model::size>()));
        writer_.add(callWith("glScalef", {size, plain(", "), size, plain(", "), size}), model_.size != 1);
        writer_.add(callWith("glScalef", numbers({&model_.scale.x, 3}, own(keyOf<&Model::scale>()))),
                    model_.scale != glm::vec3(1));
    }

    [[nodiscard]] Part floatPart(float value, const std::string& key) const {
        return number(value, own(key));
    }

    /// "model1 = sphere(32, 16);"
    void makeShape() {
        std::vector<Part> parts{plain(variable_ + " = ")};
        append(parts, shapeCall());
        parts.push_back(plain(";"));
        writer_.add(std::move(parts));
    }

    /// From where the disk begins, and how far it goes around: as core/mesh/disk.cpp has it.
    [[nodiscard]] std::vector<Part> sector() const {
        const auto part = [&](float value, const std::string& key) { return number(value, own(key)); };
        const float start = model_.startAngle;
        const float sweep = model_.sweepAngle;
        if (model_.shape == Shape::Disk)
            return {plain("0.0, 360.0")};
        if (std::abs(sweep) > 360)
            return {part(start, keyOf<&Model::startAngle>()), plain(", 360.0")};
        if (sweep >= 0)
            return {part(start, keyOf<&Model::startAngle>()), plain(", "),
                    part(sweep, keyOf<&Model::sweepAngle>())};
        return {part(start, keyOf<&Model::startAngle>()), plain(" + "),
                part(sweep, keyOf<&Model::sweepAngle>()), plain(", "),
                plain(literal(-sweep, Literal::Float))}; // backwards around it is the same sector
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

    void compileList() {
        writer_.add(fmt::format("{} = glGenLists(1);", variable_));
        writer_.add({call("glNewList"), plain(fmt::format("({}, GL_COMPILE); ", variable_)), nameComment()});
        const std::vector<SentVertex> sent = sentVertices(model_, mesh_);
        std::array<TexCoords, maxUnits> coords;
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (form_.coords[u])
                coords[u] = coordsOf(u);
            if (form_.coords[u] && !sent.empty() && !sent.front().coordsOf[u])
                writeFirstCoords(u, coordCount(coords[u]));
        }
        writer_.add({call("glBegin"), plain("("), primitivePart(), plain(");")});
        std::optional<glm::vec3> normal;
        for (const SentVertex& each : sent) {
            const std::size_t i = each.vertex;
            const Vertex& vertex = mesh_.vertices[i];
            writeFace(i);
            if (emission_.needsNormals && normal != givenNormal(i)) {
                normal = givenNormal(i);
                writer_.add(callWith("glNormal3f",
                                     numbers({&normal->x, 3}, meshPath<&MeshData::normals>(i, *normal))));
            }
            if (isColored())
                writer_.add(callWith("glColor4f", numbers({&vertex.color.x, 4},
                                                          meshPath<&MeshData::colors>(i, vertex.color))));
            writeVertex(coords, each);
        }
        writer_.add("glEnd();");
        writer_.add("glEndList();");
    }

    /// What is current where glTexCoord of the first vertices is left out.
    void writeFirstCoords(std::size_t unit, int count) {
        const glm::vec4 first(0, emission_.flipsCoords(index_, unit) ? 1 : 0, 0, 1);
        std::vector<Part> parts = coordCall(unit, count, numbers(firstOf(first, count)));
        parts.push_back(plain(" "));
        parts.push_back({Part::Kind::Comment, "/* until a vertex has its own */"});
        writer_.add(std::move(parts));
    }

    /// "glTexCoord2f(1.0f, 0.0f);", or glMultiTexCoord where several units take coordinates.
    [[nodiscard]] std::vector<Part> coordCall(std::size_t unit, int count, std::vector<Part> values) const {
        const bool isOne =
            std::none_of(form_.coords.begin() + 1, form_.coords.end(), [](bool on) { return on; });
        std::vector<Part> arguments;
        if (!isOne)
            arguments.push_back(plain(fmt::format("{}, ", textureUnitName(unit))));
        append(arguments, std::move(values));
        return callWith(fmt::format("{}{}f", isOne ? "glTexCoord" : "glMultiTexCoord", count),
                        std::move(arguments));
    }

    /// As the scene has it, of any length: GL_NORMALIZE is on.
    [[nodiscard]] glm::vec3 givenNormal(std::size_t vertex) const {
        const auto& normals = model_.mesh.normals;
        const bool isGiven = model_.shape == Shape::Mesh && normals.size() == mesh_.vertices.size() &&
                             normals[vertex] != glm::vec3(0);
        return isGiven ? normals[vertex] : normalOf(mesh_.vertices[vertex]);
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

    [[nodiscard]] Part primitivePart() const {
        return model_.shape == Shape::Mesh
                   ? choice(std::string(rowOf(sentPrimitive(model_)).name),
                            own(fmt::format("{}.{}", keyOf<&Model::mesh>(), keyOf<&MeshData::primitive>())))
                   : plain(std::string(rowOf(sentPrimitive(model_)).name));
    }

    /// Its coordinates, unless their call is left out, and its place, on one line.
    void writeVertex(const std::array<TexCoords, maxUnits>& coords, const SentVertex& sent) {
        const std::size_t vertex = sent.vertex;
        std::vector<Part> parts;
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (coords[u].empty() || sent.coordsOf[u] != sent.vertex)
                continue;
            const int count = coordCount(coords[u]);
            const std::string path = emission_.flipsCoords(index_, u)
                                         ? std::string()
                                         : fmt::format("{}[{}]", coordsPath(index_, u), vertex);
            append(parts, coordCall(u, count, numbers(firstOf(coords[u][vertex], count), path)));
            parts.push_back(plain(" "));
        }
        const glm::vec3& position = mesh_.vertices[vertex].position;
        append(parts, callWith("glVertex3f",
                               numbers({&position.x, 3}, meshPath<&MeshData::positions>(vertex, position))));
        writer_.add(std::move(parts));
    }

    void drawShape(const Pass& pass) {
        const auto pointer = [&](std::string_view array, const std::string& function,
                                 std::string_view member) {
            writer_.add(fmt::format("glEnableClientState({});", array));
            writer_.add(fmt::format("{}{}, sizeof(Vertex), {}.vertices->{});", function, floatType, variable_,
                                    member));
        };
        writer_.add("glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);");
        pointer(vertexArray, "glVertexPointer(3, ", "position");
        if (emission_.needsNormals)
            pointer(normalArray, "glNormalPointer(", "normal");
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (!takesCoords(emission_.scene, pass, u, index_))
                continue;
            writer_.add(fmt::format("glClientActiveTexture({});", textureUnitName(u)),
                        u != 0 || isSecond(pass));
            pointer(texCoordArray, "glTexCoordPointer(4, ", "texCoord");
        }
        drawElements();
    }

    /// With the arrays that are set, which are set back.
    void drawElements() {
        if (form_.drawing == Drawing::Shape) {
            writer_.add(fmt::format("glDrawElements({2}, {0}.indexCount, {1}, {0}.indices);", variable_,
                                    unsignedIntType, rowOf(Primitive::Triangles).name));
        } else if (drawsByIndices()) {
            if (isTwisted_)
                writer_.comment(
                    "the triangles of a strip that covers itself: OpenGL leaves open which come first");
            writer_.add({call("glDrawElements"), plain("("),
                         geometry().shape == Shape::Mesh && !isTwisted_
                             ? primitivePart()
                             : plain(std::string(rowOf(Primitive::Triangles).name)),
                         plain(fmt::format(", {}, {}, {}Indices);", indicesOf().size(), unsignedIntType,
                                           variable_))});
        } else {
            writer_.add({call("glDrawArrays"), plain("("), primitivePart(),
                         plain(fmt::format(", 0, {});", mesh_.vertices.size()))});
        }
        writer_.add("glPopClientAttrib();");
    }

    /// Whether a unit beside the first takes coordinates.
    [[nodiscard]] bool isSecond(const Pass& pass) const {
        for (std::size_t u = 1; u < maxUnits; ++u) {
            if (takesCoords(emission_.scene, pass, u, index_))
                return true;
        }
        return false;
    }

    /// In braces, for several passes may do it.
    void moveCoords(const Pass& pass, std::size_t unit) {
        const Emboss& emboss = pass.units[unit].emboss;
        const auto index = static_cast<std::size_t>(&pass - emission_.scene.passes.data());
        const std::string depth = unitPath(index, unit, {keyOf<&Unit::emboss>(), keyOf<&Emboss::depth>()});
        const glm::vec4& light = emission_.scene.light.position;
        writer_.add("{");
        writer_.indent();
        std::vector<Part> parts{plain("const GLfloat position[4] = {")};
        append(parts, numbers({&light.x, 4}, pathOf<&Scene::light, &Light::position>()));
        parts.push_back(plain("};"));
        writer_.add(std::move(parts));
        writer_.add("GLfloat light[4];");
        writer_.add("GLdouble modelView[16];");
        writer_.add("glGetDoublev(GL_MODELVIEW_MATRIX, modelView);");
        writer_.add(fmt::format("lightInModel(modelView, position, {}, light);",
                                emboss.carrier == LightCarrier::Transpose ? 1 : 0));
        writer_.add({plain(fmt::format("emboss({0}, {1}Positions, {1}GivenCoords{2}, {1}Tangents{2}, light, ",
                                       mesh_.vertices.size(), variable_, unit)),
                     number(emboss.depth, depth),
                     plain(fmt::format(", {}EmbossedCoords{});", variable_, unit))});
        writer_.outdent();
        writer_.add("}");
    }

    void drawArrays(const Pass& pass) {
        writeSize();
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (takesCoords(emission_.scene, pass, u, index_) && pass.units[u].emboss.enabled)
                moveCoords(pass, u);
        }
        writer_.add("glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);");
        point(vertexArray, "glVertexPointer(3, ", "Positions");
        if (emission_.needsNormals)
            point(normalArray, "glNormalPointer(", "Normals");
        if (isColored())
            point(colorArray, "glColorPointer(4, ", "Colors");
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& unit = pass.units[u];
            if (!takesCoords(emission_.scene, pass, u, index_))
                continue;
            writer_.add(fmt::format("glClientActiveTexture({});", textureUnitName(u)),
                        u != 0 || isSecond(pass));
            const bool moves = unit.emboss.enabled;
            point(texCoordArray, fmt::format("glTexCoordPointer({}, ", moves ? 4 : coordComponents(u)),
                  moves ? fmt::format("EmbossedCoords{}", u) : coordsName(u));
        }
        drawElements();
    }

    void point(std::string_view array, const std::string& function, std::string_view name) {
        writer_.add(fmt::format("glEnableClientState({});", array));
        writer_.add(fmt::format("{}{}, 0, {}{});", function, floatType, variable_, name));
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    SentModel sent_;
    const ModelForm& form_;
    std::size_t index_;
    std::string path_;
    std::string variable_;
    Mesh mesh_; ///< where its numbers are written
    bool isTwisted_;
};

} // namespace

void writeModelData(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).declare();
}

std::vector<Part> shapeCall(Emission& emission, std::size_t model) {
    return ModelWriter(emission, model).shapeCall();
}

void writeModelSetup(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).setUp();
}

void writeModelShape(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).drawShape();
}

void writeModel(Emission& emission, std::size_t pass, std::size_t model) {
    ModelWriter(emission, model).draw(emission.scene.passes[pass]);
}

} // namespace texplorer::emit

// Models in vertex buffers: OpenGL 3.3, core profile.

#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/glsl_emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// "{1.0f, 0.0f}"
std::vector<Part> braced(std::span<const float> values) {
    std::vector<Part> parts{plain("{")};
    append(parts, numbers(values));
    parts.push_back(plain("}"));
    return parts;
}

std::string_view drawnPrimitive(const Mesh& mesh) {
    return rowOf(!mesh.triangles.empty() ? Primitive::Triangles
                 : !mesh.lines.empty()   ? Primitive::Lines
                                         : Primitive::Points)
        .name;
}

/// Whether any shader looks at normals.
bool looksAtNormals(const GlslEmission& glsl) {
    return std::ranges::any_of(glsl.passes, [](const GlslPass& pass) {
        return pass.source.vertex.text.find("normalMatrix * normal") != std::string::npos;
    });
}

class BufferWriter {
public:
    BufferWriter(GlslEmission& glsl, std::size_t index)
        : glsl_(glsl)
        , emission_(glsl.emission)
        , writer_(glsl.emission.writer)
        , model_(glsl.emission.scene.models[index])
        , sent_(model_)
        , index_(index)
        , path_(elementOf<&Scene::models>(index))
        , variable_(fmt::format("model{}", index))
        , isShape_(isTurned(sent_->shape) && !isEmbossed())
        , hasNormals_(looksAtNormals(glsl)) {
        mesh_ = meshOf(*sent_);
        isSmall_ = mesh_.vertices.size() <= maxWrittenVertices &&
                   drawnIndices(mesh_).size() <= 3 * maxWrittenVertices;
    }

    /// Whether a pass draws it.
    [[nodiscard]] bool isDrawn() const {
        return !drawnIndices(mesh_).empty() &&
               std::ranges::any_of(glsl_.arrays,
                                   [&](const VertexArray& array) { return array.model == index_; });
    }

    void declare() {
        const Part comment{Part::Kind::Comment, fmt::format("/* {} */", inComment(nameOf(model_)))};
        for (const VertexArray& array : glsl_.arrays) {
            if (array.model == index_)
                emission_.atStart.add({plain(fmt::format("static GLuint {}; ", array.name)), comment});
        }
        if (isShape_) {
            emission_.atStart.add(fmt::format("static GLsizei {}Count; /* of its indices */", variable_));
            emission_.use(CFunction::MeshTypes);
        } else
            declareVertices();
        if (!isShape_)
            declareIndices();
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            for (const CoordForm form : {CoordForm::AsGiven, CoordForm::Flipped, CoordForm::Embossed}) {
                if (hasForm(unit, form))
                    declareCoords(unit, form);
            }
        }
    }

    void setUp() {
        emission_.use(CFunction::Buffers);
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        if (isShape_) {
            std::vector<Part> parts{plain(fmt::format("const Mesh {}Mesh = ", variable_))};
            append(parts, shapeCall(emission_, index_));
            parts.push_back(plain(";"));
            writer_.add(std::move(parts));
            writer_.add(fmt::format("{0}Count = {0}Mesh.indexCount;", variable_));
        }
        for (const VertexArray& array : glsl_.arrays) {
            if (array.model == index_)
                setUpArray(array);
        }
        if (isShape_) {
            writer_.add(fmt::format("free({}Mesh.vertices);", variable_));
            writer_.add(fmt::format("free({}Mesh.indices);", variable_));
        }
    }

    void draw(const GlslPass& pass) {
        const VertexArray& array = glsl_.arrayOf(pass, index_);
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        const bool isPlaced = place();
        const bool isSeen = model_.attachment != Attachment::Eye;
        const std::string modelView = !isSeen ? "model" : isPlaced ? "multiplyFloats(view, model)" : "view";
        writer_.add(fmt::format("place({}projection, {});",
                                glsl_.passes.size() > 1 ? pass.program + ", " : std::string(), modelView));
        writeGlslMaterial(glsl_, pass, index_);
        for (std::size_t u = 0; u < maxUnits; ++u)
            writeGlslMatrix(glsl_, pass, u, MatrixTime::Model, index_);
        writeSize();
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            if (array.coords[unit] == CoordForm::Embossed && pass.units[unit])
                moveCoords(pass, unit, modelView);
        }
        writer_.add(fmt::format("glBindVertexArray({});", array.name));
        drawElements();
    }

    /// Where the light sees it.
    void drawDepths() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        const bool isPlaced = place();
        const bool isSeen = model_.attachment != Attachment::Eye;
        const auto array = std::ranges::find(glsl_.arrays, index_, &VertexArray::model);
        emission_.use(CFunction::FloatProduct);
        emission_.use(CFunction::SetMatrix);
        writer_.add(fmt::format("setMatrix(shadowProgram, \"modelViewProjection\", multiply(light, {}));",
                                !isSeen    ? "model"
                                : isPlaced ? "multiplyFloats(view, model)"
                                           : "view"));
        writeSize();
        writer_.add(fmt::format("glBindVertexArray({});", array->name));
        drawElements();
    }

private:
    void drawElements() {
        writer_.add(fmt::format("glDrawElements({}, {}, {}, NULL);", drawnPrimitive(mesh_),
                                isShape_ ? variable_ + "Count" : std::to_string(drawnIndices(mesh_).size()),
                                unsignedIntType));
    }

    [[nodiscard]] std::string own(std::string_view key) const { return fmt::format("{}.{}", path_, key); }

    [[nodiscard]] bool hasForm(std::size_t unit, CoordForm form) const {
        return std::ranges::any_of(glsl_.arrays, [&](const VertexArray& array) {
            return array.model == index_ && array.coords[unit] == form;
        });
    }
    [[nodiscard]] bool isEmbossed() const {
        return std::ranges::any_of(glsl_.arrays, [&](const VertexArray& array) {
            return array.model == index_ &&
                   std::ranges::find(array.coords, CoordForm::Embossed) != array.coords.end();
        });
    }
    [[nodiscard]] bool isColored() const { return mesh_.colored; }
    /// Whether an array of its own has the coordinates; else they are the shape's.
    [[nodiscard]] bool hasOwnCoords(std::size_t unit, CoordForm form) const {
        return form == CoordForm::Flipped || !sent_->texCoords[unit].empty();
    }

    void declareVertices() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        if (leavesOutCalls(model_))
            writer_.comment("a vertex without glTexCoord has the coordinates of the one before it");
        if (isEmbossed()) {
            table("Positions", 3,
                  [](const Vertex& vertex, std::size_t) { return glm::vec4(vertex.position, 0); });
            if (hasNormals_)
                table("Normals", 3,
                      [](const Vertex& vertex, std::size_t) { return glm::vec4(vertex.normal, 0); });
        } else
            declareStructs();
        if (isColored())
            table("Colors", 4, [](const Vertex& vertex, std::size_t) { return vertex.color; });
    }

    /// "{{-1.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f, 1.0f}},"
    static std::vector<Part> rowOfVertex(const Vertex& vertex) {
        std::vector<Part> parts{plain("{")};
        append(parts, braced({&vertex.position.x, 3}));
        parts.push_back(plain(", "));
        append(parts, braced({&vertex.normal.x, 3}));
        parts.push_back(plain(", "));
        append(parts, braced({&vertex.texCoord.x, 4}));
        parts.push_back(plain("},"));
        return parts;
    }

    void declareStructs() {
        emission_.use(CFunction::MeshTypes);
        if (!isSmall_) {
            std::string text;
            for (const Vertex& vertex : mesh_.vertices)
                text += "    " + textOf(Line{rowOfVertex(vertex)}) + "\n";
            return emission_.addData("Vertex", variable_ + "Vertices", mesh_.vertices.size(),
                                     std::move(text));
        }
        writer_.add({plain(fmt::format("static const Vertex {}Vertices[] = {{ ", variable_)),
                     {Part::Kind::Comment, "/* position, normal, texture coordinates */"}});
        writer_.indent();
        for (const Vertex& vertex : mesh_.vertices)
            writer_.add(rowOfVertex(vertex));
        writer_.outdent();
        writer_.add("};");
    }

    /// An array with a row for each vertex.
    template<class Get>
    void table(const std::string& name, int count, Get get, const std::string& path = {}) {
        std::string text;
        if (isSmall_) {
            writer_.add(fmt::format("static const GLfloat {}{}[] = {{", variable_, name));
            writer_.indent();
        }
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const glm::vec4 values = get(mesh_.vertices[i], i);
            std::vector<Part> parts = numbers({&values.x, static_cast<std::size_t>(count)},
                                              path.empty() ? path : fmt::format("{}[{}]", path, i));
            parts.push_back(plain(","));
            if (isSmall_)
                writer_.add(std::move(parts));
            else
                text += "    " + textOf(Line{parts}) + "\n";
        }
        if (!isSmall_)
            return emission_.addData("GLfloat", variable_ + name,
                                     mesh_.vertices.size() * static_cast<std::size_t>(count),
                                     std::move(text));
        writer_.outdent();
        writer_.add("};");
    }

    void declareCoords(std::size_t unit, CoordForm form) {
        TexCoords coords = effectiveTexCoords(*sent_, mesh_, static_cast<int>(unit));
        if (form == CoordForm::Embossed) {
            table(coordsName(unit, form), 4, [&](const Vertex&, std::size_t i) { return coords[i]; });
            std::vector<glm::vec4> all;
            for (const Tangents& each : tangentsOf(mesh_, coords))
                all.insert(all.end(), {glm::vec4(each.s, 0), glm::vec4(each.t, 0)});
            std::string text;
            for (std::size_t i = 0; i < all.size(); ++i)
                text += fmt::format("{}{},{}", i % 2 == 0 ? "    " : " ",
                                    textOf(Line{numbers({&all[i].x, 3})}), i % 2 == 0 ? "" : "\n");
            emission_.addData("GLfloat", fmt::format("{}Tangents{}", variable_, unit), 3 * all.size(),
                              std::move(text));
            emission_.atStart.add({plain(fmt::format("static GLfloat {}Embossed{}[{}]; ", variable_, unit,
                                                     4 * mesh_.vertices.size())),
                                   {Part::Kind::Comment, "/* in every frame moved towards the light */"}});
            emission_.atStart.add(fmt::format("static GLuint {}EmbossedBuffer{};", variable_, unit));
            emission_.use(CFunction::LightInModel);
            emission_.use(CFunction::Emboss);
            return;
        }
        if (form == CoordForm::Flipped) {
            for (glm::vec4& coord : coords)
                coord.t = coord.q - coord.t;
        }
        if (hasOwnCoords(unit, form) || isEmbossed())
            table(
                coordsName(unit, form), 4, [&](const Vertex&, std::size_t i) { return coords[i]; },
                form == CoordForm::Flipped || leavesOutCalls(model_)
                    ? std::string()
                    : own(findKey(memberId<&Model::texCoords>, unit)));
    }

    static std::string coordsName(std::size_t unit, CoordForm form) {
        return fmt::format("{}TexCoords{}",
                           form == CoordForm::Flipped    ? "Flipped"
                           : form == CoordForm::Embossed ? "Given"
                                                         : "",
                           unit);
    }

    void declareIndices() {
        std::string text;
        const std::vector<std::uint32_t>& indices = drawnIndices(mesh_);
        constexpr std::size_t columns = 18;
        for (std::size_t i = 0; i < indices.size(); ++i)
            text += fmt::format("{}{},{}", i % columns == 0 ? "    " : " ", indices[i],
                                i % columns == columns - 1 || i + 1 == indices.size() ? "\n" : "");
        if (!isSmall_)
            return emission_.addData("GLuint", variable_ + "Indices", indices.size(), std::move(text));
        writer_.add(fmt::format("static const GLuint {}Indices[] = {{", variable_));
        writer_.indent();
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            writer_.add(text.substr(at + 4, end - at - 4));
            at = end + 1;
        }
        writer_.outdent();
        writer_.add("};");
    }

    void fill(std::string_view target, const std::string& array, bool isMade = false) {
        if (isMade)
            writer_.add(fmt::format("newBuffer({0}, (size_t){1}Mesh.{2} * sizeof *{1}Mesh.{3}, {1}Mesh.{3});",
                                    target, variable_, array == "vertices" ? "vertexCount" : "indexCount",
                                    array));
        else
            writer_.add(fmt::format("newBuffer({0}, sizeof {1}{2}, {1}{2});", target, variable_, array));
    }

    void attribute(unsigned location, int count, std::string_view stride, std::string_view offset,
                   std::string_view what) {
        writer_.add({plain(fmt::format("attribute({}, {}, {}, {}); ", location, count, stride, offset)),
                     {Part::Kind::Comment, fmt::format("/* {} */", what)}});
    }

    void setUpArray(const VertexArray& array) {
        const auto unitWords = [](std::size_t unit) { return fmt::format("coordinates of unit {}", unit); };
        writer_.add(fmt::format("glGenVertexArrays(1, &{});", array.name));
        writer_.add(fmt::format("glBindVertexArray({});", array.name));
        if (isEmbossed()) {
            fill(arrayBuffer, "Positions");
            attribute(glsl::positionAttribute, 3, "0", "0", "position");
            if (hasNormals_) {
                fill(arrayBuffer, "Normals");
                attribute(glsl::normalAttribute, 3, "0", "0", "normal");
            }
        } else {
            fill(arrayBuffer, isShape_ ? "vertices" : "Vertices", isShape_);
            attribute(glsl::positionAttribute, 3, "sizeof(Vertex)", "offsetof(Vertex, position)", "position");
            if (hasNormals_)
                attribute(glsl::normalAttribute, 3, "sizeof(Vertex)", "offsetof(Vertex, normal)", "normal");
            for (std::size_t unit = 0; unit < maxUnits; ++unit) {
                if (array.coords[unit] == CoordForm::AsGiven && !hasOwnCoords(unit, array.coords[unit]))
                    attribute(glsl::firstCoordAttribute + static_cast<unsigned>(unit), 4, "sizeof(Vertex)",
                              "offsetof(Vertex, texCoord)", unitWords(unit));
            }
        }
        if (isColored()) {
            fill(arrayBuffer, "Colors");
            attribute(glsl::colorAttribute, 4, "0", "0", "colour");
        }
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            const CoordForm form = array.coords[unit];
            if (form == CoordForm::Off ||
                (form == CoordForm::AsGiven && !isEmbossed() && !hasOwnCoords(unit, form)))
                continue;
            if (form == CoordForm::Embossed && embossed_.insert(unit).second)
                writer_.add(fmt::format(
                    "{0}EmbossedBuffer{1} = newBuffer(GL_ARRAY_BUFFER, sizeof {0}Embossed{1}, NULL);",
                    variable_, unit));
            else if (form == CoordForm::Embossed)
                writer_.add(
                    fmt::format("glBindBuffer(GL_ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
            else
                fill(arrayBuffer, coordsName(unit, form));
            attribute(glsl::firstCoordAttribute + static_cast<unsigned>(unit), 4, "0", "0", unitWords(unit));
        }
        fill(elementArrayBuffer, isShape_ ? "indices" : "Indices", isShape_);
    }

    /// Whether it isn't where the camera looks, as it is.
    bool place() {
        MatrixProduct product(emission_, "model", !glsl_.hasModelMatrix);
        if (model_.position != glm::vec3(0) || writer_.moves(own(keyOf<&Model::position>())))
            product.addTranslation(numbers({&model_.position.x, 3}, own(keyOf<&Model::position>())));
        constexpr std::array axes{"1, 0, 0", "0, 1, 0", "0, 0, 1"};
        for (const int axis : rotationAxes(model_.rotationOrder)) {
            const bool spins = model_.spin[axis] != 0 || writer_.moves(own(keyOf<&Model::spin>()));
            if (!spins && model_.rotation[axis] == 0 && !writer_.moves(own(keyOf<&Model::rotation>())))
                continue;
            std::vector<Part> angle{number(model_.rotation[axis], own(keyOf<&Model::rotation>()), axis)};
            if (spins)
                append(angle, {plain(" + "), number(model_.spin[axis], own(keyOf<&Model::spin>()), axis),
                               plain(" * "), writer_.seconds()});
            product.addRotation(std::move(angle), {plain(axes.at(static_cast<std::size_t>(axis)))});
        }
        if (model_.size != 1 || writer_.moves(own(keyOf<&Model::size>()))) {
            const Part size = number(model_.size, own(keyOf<&Model::size>()));
            product.addScaling({size, plain(", "), size, plain(", "), size});
        }
        if (model_.scale != glm::vec3(1) || writer_.moves(own(keyOf<&Model::scale>())))
            product.addScaling(numbers({&model_.scale.x, 3}, own(keyOf<&Model::scale>())));
        const bool isPlaced = !product.isEmpty();
        if (model_.attachment == Attachment::Eye)
            product.finish();
        glsl_.hasModelMatrix |= !product.isEmpty();
        return isPlaced;
    }

    /// Of lines and points: always, where any model has another.
    void writeSize() {
        static const Model initial;
        const Holder holder{modelTable(), &model_, &initial, path_, "model", variable_};
        const int corners = partCorners(model_);
        if (corners == 3)
            return;
        const MemberId member = corners == 2 ? memberId<&Model::lineWidth> : memberId<&Model::pointSize>;
        const auto row = std::ranges::find(holder.table.params, member, &ParamRow::member);
        bool isPlain = true;
        for (std::size_t m = 0; m < emission_.scene.models.size(); ++m)
            isPlain &= row->read(&emission_.scene.models[m]) == row->read(&initial) &&
                       !writer_.moves(fmt::format("{}.{}", elementOf<&Scene::models>(m), row->key));
        if (isPlain)
            return;
        writer_.forget(fmt::format("{}.{}", holder.state, row->key));
        writer_.row(holder, *row);
    }

    void moveCoords(const GlslPass& pass, std::size_t unit, const std::string& modelView) {
        const Emboss& settings = emission_.scene.passes[pass.index].units[unit].emboss;
        const glm::vec4& light = emission_.scene.light.position;
        const std::string name = joined(pass.variable, fmt::format("model{}Light{}", index_, unit));
        writer_.add(fmt::format("GLfloat {}[4];", name));
        std::vector<Part> parts{plain(fmt::format("lightInModel({}.at, (const GLfloat[]){{", modelView))};
        append(parts, numbers({&light.x, 4}, pathOf<&Scene::light, &Light::position>()));
        parts.push_back(
            plain(fmt::format("}}, {}, {});", settings.carrier == LightCarrier::Transpose ? 1 : 0, name)));
        writer_.add(std::move(parts));
        std::vector<Part> moved{
            plain(fmt::format("emboss({0}, {1}Positions, {1}GivenTexCoords{2}, {1}Tangents{2}, {3}, ",
                              mesh_.vertices.size(), variable_, unit, name))};
        moved.push_back(number(
            settings.depth, unitPath(pass.index, unit, {keyOf<&Unit::emboss>(), keyOf<&Emboss::depth>()})));
        moved.push_back(plain(fmt::format(", {}Embossed{});", variable_, unit)));
        writer_.add(std::move(moved));
        writer_.add(fmt::format("glBindBuffer(GL_ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
        writer_.add(fmt::format("glBufferData(GL_ARRAY_BUFFER, sizeof {0}Embossed{1}, {0}Embossed{1}, "
                                "GL_STREAM_DRAW);",
                                variable_, unit));
    }

    GlslEmission& glsl_;
    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    SentModel sent_; ///< its vertices, one for each that is sent
    std::size_t index_;
    std::string path_;
    std::string variable_;
    bool isShape_; ///< a function makes its mesh
    bool hasNormals_;
    bool isSmall_ = false; ///< its numbers stand where they are used
    Mesh mesh_;
    std::set<std::size_t> embossed_{}; ///< units whose buffer there is: vertex array objects share it
};

} // namespace

std::array<CoordForm, maxUnits> coordFormsOf(const Emission& emission, const GlslPass& pass) {
    std::array<CoordForm, maxUnits> forms{};
    for (std::size_t i = 0; i < maxUnits; ++i) {
        if (!pass.units[i])
            continue;
        const Unit& unit = emission.scene.passes[pass.index].units[i];
        forms[i] = unit.emboss.enabled                                ? CoordForm::Embossed
                   : pass.units[i]->lateFlip == LateFlip::Coordinates ? CoordForm::Flipped
                                                                      : CoordForm::AsGiven;
    }
    return forms;
}

void writeGlslModelData(GlslEmission& glsl, std::size_t model) {
    if (BufferWriter writer(glsl, model); writer.isDrawn())
        writer.declare();
}

void writeGlslModelSetup(GlslEmission& glsl, std::size_t model) {
    if (BufferWriter writer(glsl, model); writer.isDrawn())
        writer.setUp();
}

void writeGlslShape(GlslEmission& glsl, std::size_t model) {
    if (BufferWriter writer(glsl, model); writer.isDrawn())
        writer.drawDepths();
}

void writeGlslModel(GlslEmission& glsl, const GlslPass& pass, std::size_t model) {
    if (BufferWriter writer(glsl, model); writer.isDrawn())
        writer.draw(pass);
}

} // namespace texplorer::emit

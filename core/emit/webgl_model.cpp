// Models in vertex buffers, in JavaScript.

#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/webgl.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Floats: position, normal and coordinates of a vertex.
constexpr std::size_t floatsOfVertex = 10;

template<class T>
ByteView bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

class WebModelWriter {
public:
    WebModelWriter(GlslEmission& glsl, std::size_t index)
        : glsl_(glsl)
        , writer_(glsl.emission.writer)
        , model_(glsl.emission.scene.models[index])
        , index_(index)
        , variable_(fmt::format("model{}", index))
        , mesh_(meshOf(model_)) {}

    [[nodiscard]] bool isDrawn() const {
        return !drawnIndices(mesh_).empty() &&
               std::ranges::any_of(glsl_.arrays,
                                   [&](const VertexArray& array) { return array.model == index_; });
    }

    void declare() {
        for (const VertexArray& array : glsl_.arrays) {
            if (array.model == index_)
                glsl_.emission.atStart.add(fmt::format("let {}; // {}", array.name, nameOfModel()));
        }
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        if (isTurned(model_.shape))
            declareShape();
        else
            declareMesh();
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            for (const CoordForm form : {CoordForm::AsGiven, CoordForm::Flipped, CoordForm::Embossed}) {
                if (hasForm(unit, form))
                    declareCoords(unit, form);
            }
        }
    }

    /// A function makes it.
    void declareShape() {
        std::vector<Part> parts{
            plain(fmt::format("const {{vertices: {0}Vertices, indices: {0}Indices}} = ", variable_))};
        append(parts, shapeCall(glsl_.emission, index_));
        parts.push_back(plain(";"));
        writer_.add(std::move(parts));
    }

    void declareMesh() {
        std::vector<float> values;
        for (const Vertex& vertex : mesh_.vertices) {
            values.insert(values.end(), &vertex.position.x, &vertex.position.x + 3);
            values.insert(values.end(), &vertex.normal.x, &vertex.normal.x + 3);
            values.insert(values.end(), &vertex.texCoord.x, &vertex.texCoord.x + 4);
        }
        floats("Vertices", values, floatsOfVertex, "position, normal, texture coordinates");
        if (mesh_.colored) {
            values.clear();
            for (const Vertex& vertex : mesh_.vertices)
                values.insert(values.end(), &vertex.color.x, &vertex.color.x + 4);
            floats("Colors", values, 4, "red, green, blue, alpha");
        }
        declareIndices();
    }

    void setUp() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        for (const VertexArray& array : glsl_.arrays) {
            if (array.model == index_)
                setUpArray(array);
        }
    }

    void moveCoords(const GlslPass& pass, const std::string& modelView) {
        const VertexArray& array = glsl_.arrayOf(pass, index_);
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            if (array.coords[unit] != CoordForm::Embossed)
                continue;
            const Emboss& settings = glsl_.emission.scene.passes[pass.index].units[unit].emboss;
            const glm::vec4& light = glsl_.emission.scene.light.position;
            writer_.add(fmt::format("gl.bindBuffer(gl.ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
            writer_.add(fmt::format(
                "gl.bufferData(gl.ARRAY_BUFFER, emboss({0}Vertices, {0}GivenTexCoords{1}, "
                "{0}Tangents{1}, lightInModel({2}, [{3}, {4}, {5}, {6}], {7}), {8}), gl.STREAM_DRAW);",
                variable_, unit, modelView, light.x, light.y, light.z, light.w,
                settings.carrier == LightCarrier::Transpose, settings.depth));
        }
    }

private:
    [[nodiscard]] std::string nameOfModel() const { return inComment(nameOf(model_)); }

    [[nodiscard]] bool hasForm(std::size_t unit, CoordForm form) const {
        return std::ranges::any_of(glsl_.arrays, [&](const VertexArray& array) {
            return array.model == index_ && array.coords[unit] == form;
        });
    }
    [[nodiscard]] bool isOwn(std::size_t unit, CoordForm form) const {
        return form == CoordForm::Flipped || !model_.texCoords[unit].empty();
    }
    [[nodiscard]] bool isSmall() const { return mesh_.vertices.size() <= maxWrittenVertices; }

    /// A typed array with so many numbers for each vertex.
    void floats(const std::string& name, const std::vector<float>& values, std::size_t columns,
                std::string_view what) {
        const std::string array = variable_ + name;
        if (!isSmall()) {
            glsl_.emission.atEnd.add(fmt::format("const {} = new Float32Array(bytes({}).buffer); // {}",
                                                 array, base64Text(bytesOf(values)), what));
            return;
        }
        writer_.add(fmt::format("const {} = new Float32Array([ // {}", array, what));
        writer_.indent();
        for (std::size_t at = 0; at < values.size(); at += columns) {
            std::string row;
            for (std::size_t i = at; i < std::min(at + columns, values.size()); ++i)
                row += fmt::format("{}{},", i == at ? "" : " ", values[i] == 0 ? 0 : values[i]);
            writer_.add(row);
        }
        writer_.outdent();
        writer_.add("]);");
    }

    static std::string coordsName(std::size_t unit, CoordForm form) {
        return fmt::format("{}TexCoords{}",
                           form == CoordForm::Flipped    ? "Flipped"
                           : form == CoordForm::Embossed ? "Given"
                                                         : "",
                           unit);
    }

    void declareCoords(std::size_t unit, CoordForm form) {
        TexCoords coords = effectiveTexCoords(model_, mesh_, static_cast<int>(unit));
        if (form == CoordForm::Embossed) {
            std::vector<float> tangents;
            for (const Tangents& each : tangentsOf(mesh_, coords)) {
                tangents.insert(tangents.end(), &each.s.x, &each.s.x + 3);
                tangents.insert(tangents.end(), &each.t.x, &each.t.x + 3);
            }
            floats(fmt::format("Tangents{}", unit), tangents, 6, "along s and along t");
            glsl_.emission.atStart.add(fmt::format(
                "let {}EmbossedBuffer{}; // in every frame moved towards the light", variable_, unit));
        }
        if (form == CoordForm::Flipped) {
            for (glm::vec4& coord : coords)
                coord.t = coord.q - coord.t;
        }
        if (form != CoordForm::Embossed && !isOwn(unit, form))
            return;
        std::vector<float> values;
        for (const glm::vec4& coord : coords)
            values.insert(values.end(), &coord.x, &coord.x + 4);
        floats(coordsName(unit, form), values, 4, "s, t, r, q");
    }

    void declareIndices() {
        const std::vector<std::uint32_t>& indices = drawnIndices(mesh_);
        if (indices.size() > 3 * maxWrittenVertices) {
            glsl_.emission.atEnd.add(fmt::format("const {}Indices = new Uint32Array(bytes({}).buffer);",
                                                 variable_, base64Text(bytesOf(indices))));
            return;
        }
        std::string list;
        for (const std::uint32_t each : indices)
            list += fmt::format("{}{}", list.empty() ? "" : ", ", each);
        writer_.add(fmt::format("const {}Indices = new Uint32Array([{}]);", variable_, list));
    }

    void buffer(const std::string& name) {
        writer_.add(fmt::format("newBuffer(gl.ARRAY_BUFFER, {}{});", variable_, name));
    }

    void attribute(unsigned location, int count, std::size_t stride, std::size_t offset,
                   std::string_view what) {
        writer_.add(fmt::format("attribute({}, {}, {}, {}); // {}", location, count, stride, offset, what));
    }

    void setUpArray(const VertexArray& array) {
        writer_.add(fmt::format("{} = gl.createVertexArray();", array.name));
        writer_.add(fmt::format("gl.bindVertexArray({});", array.name));
        buffer("Vertices");
        attribute(glsl::positionAttribute, 3, floatsOfVertex, 0, "position");
        if (looksAtNormals(glsl_))
            attribute(glsl::normalAttribute, 3, floatsOfVertex, 3, "normal");
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            if (array.coords[unit] == CoordForm::AsGiven && !isOwn(unit, array.coords[unit]))
                coordAttribute(unit, floatsOfVertex, 6);
        }
        if (mesh_.colored) {
            buffer("Colors");
            attribute(glsl::colorAttribute, 4, 4, 0, "colour");
        }
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            const CoordForm form = array.coords[unit];
            if (form == CoordForm::Off || (form == CoordForm::AsGiven && !isOwn(unit, form)))
                continue;
            if (form == CoordForm::Embossed && embossed_.insert(unit).second)
                writer_.add(fmt::format("{0}EmbossedBuffer{1} = newBuffer(gl.ARRAY_BUFFER, {0}{2});",
                                        variable_, unit, coordsName(unit, form)));
            else if (form == CoordForm::Embossed)
                writer_.add(
                    fmt::format("gl.bindBuffer(gl.ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
            else
                buffer(coordsName(unit, form));
            coordAttribute(unit, 4, 0);
        }
        writer_.add(fmt::format("newBuffer(gl.ELEMENT_ARRAY_BUFFER, {}Indices);", variable_));
    }

    void coordAttribute(std::size_t unit, std::size_t stride, std::size_t offset) {
        attribute(glsl::firstCoordAttribute + static_cast<unsigned>(unit), 4, stride, offset,
                  fmt::format("coordinates of unit {}", unit));
    }

    GlslEmission& glsl_;
    CodeWriter& writer_;
    const Model& model_;
    std::size_t index_;
    std::string variable_;
    Mesh mesh_;
    std::set<std::size_t> embossed_{}; ///< units whose buffer there is: vertex array objects share it
};

} // namespace

void writeWebModelData(GlslEmission& glsl, std::size_t model) {
    if (WebModelWriter writer(glsl, model); writer.isDrawn())
        writer.declare();
}

void writeWebModelSetup(GlslEmission& glsl, std::size_t model) {
    if (WebModelWriter writer(glsl, model); writer.isDrawn())
        writer.setUp();
}

void writeWebEmboss(GlslEmission& glsl, const GlslPass& pass, std::size_t model,
                    const std::string& modelView) {
    WebModelWriter(glsl, model).moveCoords(pass, modelView);
}

} // namespace texplorer::emit

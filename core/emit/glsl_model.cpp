// Models in vertex buffers: OpenGL 3.3, core profile.

#include "texplorer/emit/glsl_emission.h"
#include "texplorer/emit/model_arrays.h"
#include "texplorer/emit/transformations.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

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
        , arrays_(glsl.emission, index)
        , index_(index)
        , variable_(arrays_.variable())
        , isShape_(isTurned(arrays_.model().shape) && !isEmbossed())
        , hasNormals_(looksAtNormals(glsl)) {}

    /// Whether a pass draws it.
    [[nodiscard]] bool isDrawn() const {
        return !drawnIndices(arrays_.mesh()).empty() &&
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
        } else {
            declareVertices();
            arrays_.writeIndices(drawnIndices(arrays_.mesh()));
        }
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
        writer_.add(
            fmt::format("glDrawElements({}, {}, {}, NULL);", drawnPrimitive(arrays_.mesh()),
                        isShape_ ? variable_ + "Count" : std::to_string(drawnIndices(arrays_.mesh()).size()),
                        unsignedIntType));
    }

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
    /// Whether an array of its own has the coordinates; else they are the shape's.
    [[nodiscard]] bool hasOwnCoords(std::size_t unit, CoordForm form) const {
        return form == CoordForm::Flipped || !arrays_.model().texCoords[unit].empty();
    }

    void declareVertices() {
        arrays_.writeHeading();
        if (isEmbossed()) {
            arrays_.writePositions();
            if (hasNormals_)
                arrays_.writeNormals();
        } else
            arrays_.writeVertices();
        if (arrays_.isColored())
            arrays_.writeColors();
    }

    void declareCoords(std::size_t unit, CoordForm form) {
        if (form == CoordForm::Embossed) {
            arrays_.writeEmbossing(unit);
            emission_.atStart.add(fmt::format("static GLuint {}EmbossedBuffer{};", variable_, unit));
        } else if (hasOwnCoords(unit, form) || isEmbossed())
            arrays_.writeCoords(coordsName(unit, form), unit, form == CoordForm::Flipped);
    }

    static std::string coordsName(std::size_t unit, CoordForm form) {
        return fmt::format("{}TexCoords{}", form == CoordForm::Flipped ? "Flipped" : "", unit);
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
        if (arrays_.isColored()) {
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
                    "{0}EmbossedBuffer{1} = newBuffer(GL_ARRAY_BUFFER, sizeof {0}EmbossedTexCoords{1}, NULL);",
                    variable_, unit));
            else if (form == CoordForm::Embossed)
                writer_.add(
                    fmt::format("glBindBuffer(GL_ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
            else
                fill(arrayBuffer, coordsName(unit, form));
            const int columns = form == CoordForm::Embossed
                                    ? 4
                                    : arrays_.columns(arrays_.coords(unit, form == CoordForm::Flipped));
            attribute(glsl::firstCoordAttribute + static_cast<unsigned>(unit), columns, "0", "0",
                      unitWords(unit));
        }
        fill(elementArrayBuffer, isShape_ ? "indices" : "Indices", isShape_);
    }

    /// Whether it isn't where the camera looks, as it is.
    bool place() {
        MatrixProduct product(emission_, "model", !glsl_.hasModelMatrix);
        addPlacement(emission_, product, index_);
        const bool isPlaced = !product.isEmpty();
        if (model_.attachment == Attachment::Eye)
            product.finish();
        glsl_.hasModelMatrix |= !product.isEmpty();
        return isPlaced;
    }

    /// Of lines and points: always, where any model has another.
    void writeSize() {
        static const Model initial;
        const Holder holder{modelTable(), &model_,  &initial, elementOf<&Scene::models>(index_),
                            "model",      variable_};
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
        writer_.add("{");
        writer_.indent();
        arrays_.writeEmboss(pass.index, unit, modelView + ".at");
        writer_.outdent();
        writer_.add("}");
        writer_.add(fmt::format("glBindBuffer(GL_ARRAY_BUFFER, {}EmbossedBuffer{});", variable_, unit));
        writer_.add(fmt::format("glBufferData(GL_ARRAY_BUFFER, sizeof {0}EmbossedTexCoords{1}, "
                                "{0}EmbossedTexCoords{1}, GL_STREAM_DRAW);",
                                variable_, unit));
    }

    GlslEmission& glsl_;
    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    ModelArrays arrays_;
    std::size_t index_;
    std::string variable_;
    bool isShape_; ///< a function makes its mesh
    bool hasNormals_;
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

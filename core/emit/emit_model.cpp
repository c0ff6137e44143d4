// Models as OpenGL 2.1 draws them: display lists, arrays, quadrics.

#include "texplorer/emit/model_arrays.h"
#include "texplorer/emit/transformations.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

class ModelWriter {
public:
    ModelWriter(Emission& emission, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , model_(emission.scene.models[index])
        , form_(emission.models[index])
        , index_(index)
        , variable_(fmt::format("model{}", index))
        , isTwisted_(isTwisted(model_)) {
        if (form_.drawing == Drawing::Arrays)
            arrays_.emplace(emission, index);
    }

    void declare() {
        const auto declareVariable = [&](std::string_view type) {
            emission_.atStart.add(
                {plain(fmt::format("static {} {}; ", type, variable_)),
                 {Part::Kind::Comment, fmt::format("/* {} */", inComment(nameOf(model_)))}});
        };
        switch (form_.drawing) {
        case Drawing::None:
        case Drawing::Quadric:
            break;
        case Drawing::Shape:
            declareVariable("Mesh");
            emission_.use(CFunction::MeshTypes);
            break;
        case Drawing::List:
            declareVariable("GLuint");
            break;
        case Drawing::Arrays:
            declareArrays();
            break;
        }
    }

    void setUp() {
        if (form_.drawing == Drawing::Shape) {
            std::vector<Part> parts{plain(variable_ + " = ")};
            append(parts, shapeCall(emission_, index_));
            parts.push_back(plain(";"));
            writer_.add(std::move(parts));
        }
        if (form_.drawing == Drawing::List)
            writeList(emission_, index_);
    }

    /// For the light: without the pass's state.
    void drawShape() {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        writer_.add("glPushMatrix();", movesMatrix());
        place();
        drawVertices([&] { usePositions(); });
        writer_.add("glPopMatrix();", movesMatrix());
    }

    void draw(std::size_t pass) {
        writer_.heading(fmt::format("model {}: {}", index_, nameOf(model_)));
        writeModelMatrices(emission_, pass, index_);
        writer_.add("glPushMatrix();", movesMatrix());
        if (model_.attachment == Attachment::Eye)
            writer_.add("glLoadIdentity();");
        place();
        writeMaterial(emission_, index_);
        writeSize();
        moveCoords(pass);
        drawVertices([&] { useArrays(emission_.scene.passes[pass]); });
        if (isColored()) // glColor is the last vertex's
            writer_.forget(fmt::format("{}.{}", keyOf<&Scene::material>(), keyOf<&Material::color>()));
        writer_.add("glPopMatrix();", movesMatrix());
        endModelMatrices(emission_);
    }

private:
    [[nodiscard]] bool isColored() const {
        return model_.shape == Shape::Mesh && !model_.mesh.colors.empty();
    }

    void declareArrays() {
        arrays_->writeHeading();
        arrays_->writePositions();
        if (emission_.needsNormals)
            arrays_->writeNormals();
        if (isColored())
            arrays_->writeColors();
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (form_.coords[u])
                arrays_->writeCoords(coordsName(u), u, emission_.flipsCoords(index_, u));
            if (form_.embossed[u])
                arrays_->writeEmbossing(u);
        }
        if (drawsByIndices())
            arrays_->writeIndices(indicesOf());
    }

    static std::string coordsName(std::size_t unit) { return fmt::format("TexCoords{}", unit); }

    /// Mesa divides the quadrilaterals of arrays without indices the other way (core/mesh/mesh.h).
    [[nodiscard]] bool drawsByIndices() const {
        const Model& model = arrays_->model();
        return hasIndices(model) || model.shape != Shape::Mesh || model.mesh.primitive == Primitive::Quads ||
               model.mesh.primitive == Primitive::QuadStrip;
    }

    /// Of a mesh those that name a vertex, in its order: the others are left out. Of a shape its triangles.
    [[nodiscard]] std::vector<std::uint32_t> indicesOf() const {
        const Model& model = arrays_->model();
        std::vector<std::uint32_t> indices =
            model.shape == Shape::Mesh && !isTwisted_ ? drawnOrder(model.mesh) : arrays_->mesh().triangles;
        if (indices.empty())
            indices.push_back(0); // C has no empty array
        return indices;
    }

    /// Whether what follows must not see its matrix.
    [[nodiscard]] bool movesMatrix() const {
        return isPlaced(emission_, index_) || model_.attachment == Attachment::Eye ||
               (form_.drawing == Drawing::Quadric && isTurnedForGlu(model_));
    }

    void place() {
        MatrixCalls calls(emission_);
        addPlacement(emission_, calls, index_);
    }

    /// The size of lines and points, where there are any.
    void writeSize() {
        static const Model initial;
        const Holder holder{modelTable(), &model_,  &initial, elementOf<&Scene::models>(index_),
                            "model",      variable_};
        const int corners = partCorners(model_);
        if (corners == 2)
            writer_.row(holder, memberId<&Model::lineWidth>);
        if (corners == 1)
            writer_.row(holder, memberId<&Model::pointSize>);
    }

    /// `use` sets the arrays, which are set back.
    template<class Use>
    void drawVertices(Use use) {
        switch (form_.drawing) {
        case Drawing::None:
            return;
        case Drawing::Quadric:
            return writeQuadric(emission_, index_);
        case Drawing::List:
            return writer_.add(fmt::format("glCallList({});", variable_));
        case Drawing::Shape:
        case Drawing::Arrays:
            writer_.add("glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);");
            use();
            drawElements();
            writer_.add("glPopClientAttrib();");
        }
    }

    void drawElements() {
        const std::string triangles(rowOf(Primitive::Triangles).name);
        if (form_.drawing == Drawing::Shape) {
            writer_.add(fmt::format("glDrawElements({2}, {0}.indexCount, {1}, {0}.indices);", variable_,
                                    unsignedIntType, triangles));
        } else if (drawsByIndices()) {
            if (isTwisted_)
                writer_.comment(
                    "the triangles of a strip that covers itself: OpenGL leaves open which come first");
            const bool isWhole = arrays_->model().shape == Shape::Mesh && !isTwisted_;
            writer_.add({call("glDrawElements"), plain("("),
                         isWhole ? primitivePart(model_, index_) : plain(triangles),
                         plain(fmt::format(", {}, {}, {}Indices);", indicesOf().size(), unsignedIntType,
                                           variable_))});
        } else {
            writer_.add({call("glDrawArrays"), plain("("), primitivePart(model_, index_),
                         plain(fmt::format(", 0, {});", arrays_->mesh().vertices.size()))});
        }
    }

    void usePositions() { point(vertexArray, "glVertexPointer(3, ", "position", "Positions"); }

    void useArrays(const Pass& pass) {
        usePositions();
        if (emission_.needsNormals)
            point(normalArray, "glNormalPointer(", "normal", "Normals");
        if (isColored())
            point(colorArray, "glColorPointer(4, ", {}, "Colors");
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (!takesCoords(emission_.scene, pass, u, index_))
                continue;
            writer_.add(fmt::format("glClientActiveTexture({});", textureUnitName(u)),
                        u != 0 || isSecond(pass));
            const bool moves = pass.units[u].emboss.enabled;
            const int columns = moves || !arrays_ ? 4 : arrays_->columns(arrays_->coords(u));
            point(texCoordArray, fmt::format("glTexCoordPointer({}, ", columns), "texCoord",
                  (moves ? "Embossed" : "") + coordsName(u));
        }
    }

    /// `member` of the vertices that a function has made, or the array of that name.
    void point(std::string_view array, const std::string& function, std::string_view member,
               const std::string& name) {
        writer_.add(fmt::format("glEnableClientState({});", array));
        writer_.add(form_.drawing == Drawing::Shape
                        ? fmt::format("{}{}, sizeof(Vertex), {}.vertices->{});", function, floatType,
                                      variable_, member)
                        : fmt::format("{}{}, 0, {}{});", function, floatType, variable_, name));
    }

    /// Whether another unit than the first takes coordinates.
    [[nodiscard]] bool isSecond(const Pass& pass) const {
        for (std::size_t u = 1; u < maxUnits; ++u) {
            if (takesCoords(emission_.scene, pass, u, index_))
                return true;
        }
        return false;
    }

    /// In braces, for several passes may do it.
    void moveCoords(std::size_t pass) {
        const Scene& scene = emission_.scene;
        for (std::size_t u = 0; u < maxUnits && form_.drawing == Drawing::Arrays; ++u) {
            if (!takesCoords(scene, scene.passes[pass], u, index_) ||
                !scene.passes[pass].units[u].emboss.enabled)
                continue;
            writer_.add("{");
            writer_.indent();
            writer_.add("GLdouble modelView[16];");
            writer_.add("glGetDoublev(GL_MODELVIEW_MATRIX, modelView);");
            arrays_->writeEmboss(pass, u, "modelView");
            writer_.outdent();
            writer_.add("}");
        }
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Model& model_;
    const ModelForm& form_;
    std::size_t index_;
    std::string variable_;
    std::optional<ModelArrays> arrays_{}; ///< where it is drawn from them
    bool isTwisted_;
};

} // namespace

void writeModelData(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).declare();
}

void writeModelSetup(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).setUp();
}

void writeModelShape(Emission& emission, std::size_t model) {
    ModelWriter(emission, model).drawShape();
}

void writeModel(Emission& emission, std::size_t pass, std::size_t model) {
    ModelWriter(emission, model).draw(pass);
}

} // namespace texplorer::emit

#include "app/ui/model/model_commands.h"

#include "core/scene/animation.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

std::string numbers(glm::vec3 v) {
    return formatNumbers({&v.x, 3}, ", ");
}

/// Lines of one struct, in the order of the calls.
class CallList {
public:
    CallList(const std::string& heading, std::string path)
        : path_(std::move(path)) {
        lines_.push_back({Command::Kind::Heading, heading, {}, false});
    }

    void add(std::string call, const std::string& key = {}, bool changed = true) {
        const std::string path = key.empty() ? path_ : fmt::format("{}.{}", path_, key);
        lines_.push_back({Command::Kind::Call, std::move(call) + ";", path, changed});
    }
    std::vector<Command> take() && { return std::move(lines_); }

private:
    std::string path_;
    std::vector<Command> lines_;
};

void addPlacement(CallList& calls, const Model& model) {
    constexpr std::array axes{"1, 0, 0", "0, 1, 0", "0, 0, 1"};
    if (model.attachment == Attachment::Eye)
        calls.add("glLoadIdentity()", keyOf<&Model::attachment>());
    calls.add(fmt::format("glTranslatef({})", numbers(model.position)), keyOf<&Model::position>(),
              model.position != glm::vec3(0));
    for (const int axis : rotationAxes(model.rotationOrder))
        calls.add(fmt::format("glRotatef({}, {})", formatNumber(model.rotation[axis]),
                              axes.at(static_cast<std::size_t>(axis))),
                  keyOf<&Model::rotation>(), model.rotation[axis] != 0);
    const glm::vec3 scale = model.scale * model.size;
    calls.add(fmt::format("glScalef({})", numbers(scale)), keyOf<&Model::size>(), scale != glm::vec3(1));
}

/// Whether what one model sets would reach the next: then each sets its own.
bool materialsDiffer(const Scene& scene) {
    return std::ranges::any_of(scene.models, [](const Model& model) {
        return model.ownMaterial || (model.shape == Shape::Mesh && !model.mesh.colors.empty());
    });
}

void addMaterial(CallList& calls, const Material& material) {
    static const Material initial;
    for (const ParamRow& row : modelMaterialTable().params) {
        const Value value = row.read(&material);
        calls.add(formatCall(row, value), fmt::format("{}.{}", keyOf<&Model::material>(), row.key),
                  value != row.read(&initial));
    }
}

void addVertices(CallList& calls, const Model& model) {
    const MeshData& mesh = model.mesh;
    static const Model initial;
    const Key size = partCorners(model) == 2 ? Key(keyOf<&Model::lineWidth>) : keyOf<&Model::pointSize>;
    const ParamRow& row = *findParam(modelTable(), size());
    if (partCorners(model) < 3)
        calls.add(formatCall(row, row.read(&model)), size(), row.read(&model) != row.read(&initial));
    const std::string_view primitive = rowOf(mesh.primitive).name;
    calls.add(mesh.indices.empty() ? fmt::format("glDrawArrays({}, 0, {})", primitive, mesh.positions.size())
                                   : fmt::format("glDrawElements({}, {}, GL_UNSIGNED_INT, indices)",
                                                 primitive, mesh.indices.size()),
              keyOf<&Model::shape>());
}

/// GLU's shapes stand along z; ours along y, as a lathe's do.
void addShape(CallList& calls, const Model& model) {
    const std::string& shape = keyOf<&Model::shape>();
    const std::string divisions = fmt::format("{}, {}", model.slices, model.stacks);
    switch (model.shape) {
    case Shape::Sphere:
        calls.add("glRotatef(-90, 1, 0, 0)", shape);
        calls.add(fmt::format("gluSphere(quadric, 1, {})", divisions), shape);
        break;
    case Shape::Cylinder:
        calls.add("glRotatef(-90, 1, 0, 0)", shape);
        calls.add("glTranslatef(0, 0, -1)", shape);
        calls.add(fmt::format("gluCylinder(quadric, 1, {}, 2, {})", formatNumber(model.topRadius), divisions),
                  shape);
        break;
    case Shape::Disk:
        calls.add(fmt::format("gluDisk(quadric, {}, 1, {})", formatNumber(model.innerRadius), divisions),
                  shape);
        break;
    case Shape::PartialDisk:
        calls.add(fmt::format("gluPartialDisk(quadric, {}, 1, {}, {}, {})", formatNumber(model.innerRadius),
                              divisions, formatNumber(model.startAngle), formatNumber(model.sweepAngle)),
                  shape);
        break;
    case Shape::Torus:
    case Shape::Teapot: // glutSolidTeapot has other coordinates, and its fronts are clockwise
        calls.add(fmt::format("glDrawElements(GL_TRIANGLES, {}, GL_UNSIGNED_INT, indices)",
                              meshOf(model).triangles.size()),
                  shape);
        break;
    case Shape::Cube:
    case Shape::Quad:
    case Shape::Floor:
        calls.add(fmt::format("glDrawArrays(GL_QUADS, 0, {})", vertexCountOf(model)), shape);
        break;
    case Shape::Mesh:
        addVertices(calls, model);
        break;
    }
}

std::string numbers(const glm::mat4& matrix) {
    return "{" + formatNumbers({&matrix[0].x, 16}, ", ") + "}";
}

/// From eye coordinates to the light's picture: as a camera in its place would be set up, and then from -1 to
/// 1 to 0 to 1.
void addLightView(CallList& calls, const Light& light) {
    const std::string& op = keyOf<&MatrixStep::op>();
    const auto [view, projection] = lightView(light);
    calls.add("glTranslatef(0.5, 0.5, 0.5)", op);
    calls.add("glScalef(0.5, 0.5, 0.5)", op);
    const Projector& projector = light.projector;
    const std::string range =
        fmt::format("{}, {}", formatNumber(projector.nearest), formatNumber(projector.farthest));
    if (light.position.w == 0) {
        const std::string half = formatNumber(static_cast<float>(1 / projection[0].x));
        calls.add(fmt::format("glOrtho(-{0}, {0}, -{0}, {0}, {1})", half, range), op);
    } else {
        calls.add(fmt::format("gluPerspective({}, 1, {})", formatNumber(projector.fieldOfView), range), op);
    }
    calls.add(fmt::format("glMultMatrixf({})", numbers(glm::mat4(view))), op);
}

} // namespace

std::vector<Command> modelCommands(const Scene& scene, std::size_t index) {
    const Model& model = scene.models[index];
    const std::string path = elementOf<&Scene::models>(index);
    CallList calls(path, path);
    calls.add("glPushMatrix()");
    addPlacement(calls, model);
    if (materialsDiffer(scene))
        addMaterial(calls, materialOf(scene, model));
    addShape(calls, model);
    calls.add("glPopMatrix()");
    return std::move(calls).take();
}

std::vector<Command> stepCommands(const MatrixStep& step, const std::string& path, const Light& light) {
    CallList calls(path, path);
    const bool pivots =
        (step.op == MatrixOp::Rotate || step.op == MatrixOp::Scale) && step.pivot != glm::vec3(0);
    const auto move = [&](glm::vec3 by) {
        calls.add(fmt::format("glTranslatef({})", numbers(by)), keyOf<&MatrixStep::pivot>());
    };
    if (pivots)
        move(step.pivot);
    const std::string& amount = keyOf<&MatrixStep::amount>();
    const std::string matrix = numbers(step.matrix);
    switch (step.op) {
    case MatrixOp::Translate:
        calls.add(fmt::format("glTranslatef({})", numbers(step.amount)), amount);
        break;
    case MatrixOp::Rotate:
        calls.add(fmt::format("glRotatef({}, {})", formatNumber(step.angle), numbers(step.amount)),
                  keyOf<&MatrixStep::angle>());
        break;
    case MatrixOp::Scale:
        calls.add(fmt::format("glScalef({})", numbers(step.amount)), amount);
        break;
    case MatrixOp::Multiply:
        calls.add(fmt::format("glMultMatrixf({})", matrix), keyOf<&MatrixStep::matrix>());
        break;
    case MatrixOp::Load:
        calls.add(fmt::format("glLoadMatrixf({})", matrix), keyOf<&MatrixStep::matrix>());
        break;
    case MatrixOp::Projector:
        addLightView(calls, light);
        break;
    }
    if (pivots)
        move(glm::vec3(0) - step.pivot);
    return std::move(calls).take();
}

} // namespace texplorer::ui

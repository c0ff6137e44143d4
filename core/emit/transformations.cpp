#include "texplorer/emit/transformations.h"

#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::emit {
namespace {

struct TransformationNames {
    std::string_view call;
    std::string_view function; ///< of C, where OpenGL has no matrices
    CFunction piece;
};

const TransformationNames& namesOf(Transformation transformation) {
    static constexpr std::array names{
        TransformationNames{"glTranslatef", "translation(", CFunction::Translation},
        TransformationNames{"glRotatef", "rotation(", CFunction::Rotation},
        TransformationNames{"glScalef", "scaling(", CFunction::Scaling},
    };
    return names.at(static_cast<std::size_t>(transformation));
}

std::vector<Part> between(std::string opening, std::vector<Part> parts, std::string closing) {
    parts.insert(parts.begin(), plain(std::move(opening)));
    parts.push_back(plain(std::move(closing)));
    return parts;
}

/// "angle, 0.0f, 1.0f, 0.0f"
std::vector<Part> aboutAxis(std::vector<Part> angle, int axis) {
    constexpr std::array axes{", 1.0f, 0.0f, 0.0f", ", 0.0f, 1.0f, 0.0f", ", 0.0f, 0.0f, 1.0f"};
    angle.push_back(plain(axes.at(static_cast<std::size_t>(axis))));
    return angle;
}

} // namespace

void MatrixCalls::add(Transformation transformation, std::vector<Part> arguments, bool changes) {
    writer_.add(callWith(namesOf(transformation).call, std::move(arguments)), changes);
}

void MatrixCalls::addMatrix(const std::string& name, const glm::mat4& matrix, const std::string& path,
                            bool loads) {
    const bool moves = writer_.moves(path); // then a variable has all of it
    if (!moves)
        writer_.floats(name, numbers({glm::value_ptr(matrix), 16}, path));
    writer_.add(callWith(loads ? "glLoadMatrixf" : "glMultMatrixf",
                         {{Part::Kind::Plain, name, moves ? path : std::string()}}));
}

void MatrixCalls::addProjector(const std::string& name) {
    writer_.add("glTranslatef(0.5f, 0.5f, 0.5f);");
    writer_.add("glScalef(0.5f, 0.5f, 0.5f);");
    writeLightProjection(emission_);
    writeLightView(emission_, name);
}

std::vector<Part> MatrixCalls::atTime(const Part& start, const Part& rate, bool isAngle) {
    return {plain(isAngle ? "(GLfloat)fmod(" : "(GLfloat)("),
            start,
            plain(" + "),
            rate,
            plain(" * "),
            writer_.seconds(),
            plain(isAngle ? ", 360.0)" : ")")};
}

void MatrixProduct::add(Transformation transformation, std::vector<Part> arguments, bool changes) {
    const auto moves = [&](const Part& part) { return writer_.moves(part.path); };
    if (!changes && std::ranges::none_of(arguments, moves))
        return;
    emission_.use(namesOf(transformation).piece);
    addFactor(between(std::string(namesOf(transformation).function), std::move(arguments), ")"));
}

void MatrixProduct::addMatrix(const std::string& name, const glm::mat4& matrix, const std::string& path,
                              bool /*loads*/) {
    writer_.matrix(fmt::format("const Matrix {} = {{{{", name), numbers({glm::value_ptr(matrix), 16}, path),
                   "}};");
    addFactor({plain(name)});
}

void MatrixProduct::addProjector(const std::string& name) {
    const glm::dmat4 matrix = emission_.keys.decided(
        emission_.scene, lightPaths(),
        [](const Scene& scene) {
            constexpr glm::dmat4 toPicture{
                {0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 0.5, 0}, {0.5, 0.5, 0.5, 1}};
            const LightView light = lightView(scene.light);
            return toPicture * light.projection * light.view;
        },
        computedLight);
    writer_.comment("from eye coordinates to the light's picture");
    writer_.matrix(fmt::format("const Matrix {} = {{{{", name), doubles(matrix), "}};");
    addFactor({plain(name)});
}

std::vector<Part> MatrixProduct::atTime(const Part& start, const Part& rate, bool /*isAngle*/) {
    return {start, plain(" + "), rate, plain(" * "), writer_.seconds()};
}

void MatrixProduct::addFactor(std::vector<Part> factor) {
    emission_.use(CFunction::Matrices);
    const std::string declared = fmt::format("{}{} = ", declares_ ? "Matrix " : "", variable_);
    writer_.add(isEmpty_ ? between(declared, std::move(factor), ";")
                         : between(fmt::format("{0} = multiply({0}, ", variable_), std::move(factor), ");"));
    isEmpty_ = false;
}

void MatrixProduct::finish() {
    if (!isEmpty_)
        return;
    emission_.use(CFunction::Identity);
    addFactor({plain("identity")});
}

void addView(Emission& emission, Transformations& matrix) {
    const View& view = emission.scene.view;
    const auto turn = [&](const std::string& degrees, int axis) {
        matrix.add(Transformation::Rotation, aboutAxis({plain(degrees)}, axis));
    };
    matrix.add(Transformation::Translation,
               {plain(fmt::format("0.0f, 0.0f, -{}", cameraVariable(emission, memberId<&View::distance>)))});
    const std::string& roll = pathOf<&Scene::view, &View::roll>();
    if (view.roll != 0 || emission.keys.moves(roll))
        matrix.add(Transformation::Rotation, aboutAxis({number(view.roll, roll)}, 2));
    turn(cameraVariable(emission, memberId<&View::elevation>), 0);
    turn("-" + cameraVariable(emission, memberId<&View::azimuth>), 1);
    matrix.add(Transformation::Translation,
               numbers({&view.target.x, 3}, pathOf<&Scene::view, &View::target>(), Literal::Float, true),
               view.target != glm::vec3(0));
}

void addPlacement(Emission& emission, Transformations& matrix, std::size_t index) {
    const Model& model = emission.scene.models[index];
    const auto own = [path = elementOf<&Scene::models>(index)](const std::string& key) {
        return fmt::format("{}.{}", path, key);
    };
    matrix.add(Transformation::Translation, numbers({&model.position.x, 3}, own(keyOf<&Model::position>())),
               model.position != glm::vec3(0));
    for (const int axis : rotationAxes(model.rotationOrder)) {
        const std::string spin = own(keyOf<&Model::spin>());
        const bool spins = model.spin[axis] != 0 || emission.keys.moves(spin);
        const Part angle = number(model.rotation[axis], own(keyOf<&Model::rotation>()), axis);
        matrix.add(Transformation::Rotation,
                   aboutAxis(spins ? matrix.atTime(angle, number(model.spin[axis], spin, axis), true)
                                   : std::vector{angle},
                             axis),
                   spins || model.rotation[axis] != 0);
    }
    const Part size = number(model.size, own(keyOf<&Model::size>()));
    matrix.add(Transformation::Scaling, {size, plain(", "), size, plain(", "), size}, model.size != 1);
    matrix.add(Transformation::Scaling, numbers({&model.scale.x, 3}, own(keyOf<&Model::scale>())),
               model.scale != glm::vec3(1));
}

bool isPlaced(const Emission& emission, std::size_t index) {
    const Model& model = emission.scene.models[index];
    const std::array keys{&keyOf<&Model::position>(), &keyOf<&Model::rotation>(), &keyOf<&Model::spin>(),
                          &keyOf<&Model::size>(), &keyOf<&Model::scale>()};
    const auto moves = [&](const std::string* key) {
        return emission.keys.moves(fmt::format("{}.{}", elementOf<&Scene::models>(index), *key));
    };
    return model.position != glm::vec3(0) || model.rotation != glm::vec3(0) || model.spin != glm::vec3(0) ||
           model.size != 1 || model.scale != glm::vec3(1) || std::ranges::any_of(keys, moves);
}

void addStep(Emission& emission, Transformations& matrix, const PlacedStep& placed, std::size_t unit,
             const std::string& name, bool loads) {
    const MatrixStep& step = *placed.step;
    const auto own = [path = stepPath(placed, unit)](const std::string& key) {
        return fmt::format("{}.{}", path, key);
    };
    const auto isSet = [&](const glm::vec3& vector, const std::string& key) {
        return vector != glm::vec3(0) || emission.keys.moves(own(key));
    };
    const auto atTime = [&](const Part& start, float rate, const std::string& key, int component,
                            bool isAngle) {
        const std::string path = own(key);
        return rate != 0 || emission.keys.moves(path)
                   ? matrix.atTime(start, number(rate, path, component), isAngle)
                   : std::vector{start};
    };
    const auto amount = [&] {
        std::vector<Part> parts;
        for (int i = 0; i < 3; ++i) {
            if (i > 0)
                parts.push_back(plain(", "));
            append(parts, atTime(number(step.amount[i], own(keyOf<&MatrixStep::amount>()), i), step.rate[i],
                                 keyOf<&MatrixStep::rate>(), i, false));
        }
        return parts;
    };
    const bool pivots = (step.op == MatrixOp::Rotate || step.op == MatrixOp::Scale) &&
                        isSet(step.pivot, keyOf<&MatrixStep::pivot>());
    const auto move = [&](bool back) {
        if (pivots)
            matrix.add(Transformation::Translation,
                       numbers({&step.pivot.x, 3}, own(keyOf<&MatrixStep::pivot>()), Literal::Float, back));
    };
    move(false);
    switch (step.op) {
    case MatrixOp::Translate:
        matrix.add(Transformation::Translation, amount());
        break;
    case MatrixOp::Rotate: {
        if (!isSet(step.amount, keyOf<&MatrixStep::amount>()) &&
            !isSet(step.rate, keyOf<&MatrixStep::rate>()))
            break; // no axis: OpenGL leaves it undefined
        std::vector<Part> arguments = atTime(number(step.angle, own(keyOf<&MatrixStep::angle>())),
                                             step.angleRate, keyOf<&MatrixStep::angleRate>(), -1, true);
        arguments.push_back(plain(", "));
        append(arguments, amount());
        matrix.add(Transformation::Rotation, std::move(arguments), step.angle != 0 || step.angleRate != 0);
        break;
    }
    case MatrixOp::Scale:
        matrix.add(Transformation::Scaling, amount());
        break;
    case MatrixOp::Multiply:
    case MatrixOp::Load:
        matrix.addMatrix(name, step.matrix, own(keyOf<&MatrixStep::matrix>()), loads);
        break;
    case MatrixOp::Projector:
        matrix.addProjector(name);
        break;
    }
    move(true);
}

} // namespace texplorer::emit

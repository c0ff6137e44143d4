// Texture matrices, by OpenGL 2.1's calls: a stack for each unit.

#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

/// The three numbers of a vector that changes with time, "1.0f, 0.0f + 0.5f * seconds, 0.0f".
std::vector<Part> movingNumbers(CodeWriter& writer, const glm::vec3& start, const glm::vec3& rate,
                                const std::string& startPath, const std::string& ratePath) {
    std::vector<Part> parts;
    const bool moves = writer.moves(ratePath);
    for (int i = 0; i < 3; ++i) {
        if (i > 0)
            parts.push_back(plain(", "));
        append(parts, moving(writer, number(start[i], startPath, i), number(rate[i], ratePath, i),
                             moves || rate[i] != 0));
    }
    return parts;
}

/// The calls of one step of a texture matrix.
class StepWriter {
public:
    /// `variable`: what names of arrays begin with; `multiplies`: also a step that loads a matrix.
    StepWriter(Emission& emission, const PlacedStep& placed, std::size_t unit, std::string variable,
               bool multiplies)
        : emission_(emission)
        , writer_(emission.writer)
        , step_(*placed.step)
        , path_(stepPath(placed, unit))
        , variable_(std::move(variable))
        , multiplies_(multiplies) {}

    void write() {
        const bool pivots = (step_.op == MatrixOp::Rotate || step_.op == MatrixOp::Scale) &&
                            (step_.pivot != glm::vec3(0) || writer_.moves(own(keyOf<&MatrixStep::pivot>())));
        if (pivots)
            move(false);
        const std::string angle = own(keyOf<&MatrixStep::angle>());
        switch (step_.op) {
        case MatrixOp::Translate:
            writer_.add(callWith("glTranslatef", amount()));
            break;
        case MatrixOp::Rotate: {
            if (step_.rate == glm::vec3(0) && step_.amount == glm::vec3(0) &&
                !writer_.moves(own(keyOf<&MatrixStep::rate>())) &&
                !writer_.moves(own(keyOf<&MatrixStep::amount>())))
                break; // no axis: OpenGL leaves it undefined
            const std::string rate = own(keyOf<&MatrixStep::angleRate>());
            std::vector<Part> arguments =
                turning(writer_, number(step_.angle, angle), number(step_.angleRate, rate),
                        step_.angleRate != 0 || writer_.moves(rate));
            arguments.push_back(plain(", "));
            append(arguments, amount());
            writer_.add(callWith("glRotatef", std::move(arguments)),
                        step_.angle != 0 || step_.angleRate != 0);
            break;
        }
        case MatrixOp::Scale:
            writer_.add(callWith("glScalef", amount()));
            break;
        case MatrixOp::Multiply:
            matrix("glMultMatrixf", step_.matrix, own(keyOf<&MatrixStep::matrix>()));
            break;
        case MatrixOp::Load:
            matrix(multiplies_ ? "glMultMatrixf" : "glLoadMatrixf", step_.matrix,
                   own(keyOf<&MatrixStep::matrix>()));
            break;
        case MatrixOp::Projector:
            lightView();
            break;
        }
        if (pivots)
            move(true);
    }

private:
    [[nodiscard]] std::string own(std::string_view key) const { return fmt::format("{}.{}", path_, key); }

    [[nodiscard]] std::vector<Part> amount() const {
        return movingNumbers(writer_, step_.amount, step_.rate, own(keyOf<&MatrixStep::amount>()),
                             own(keyOf<&MatrixStep::rate>()));
    }

    void move(bool back) {
        writer_.add(callWith("glTranslatef", numbers({&step_.pivot.x, 3}, own(keyOf<&MatrixStep::pivot>()),
                                                     Literal::Float, back)));
    }

    void matrix(std::string_view name, const glm::mat4& values, const std::string& path) {
        const bool moves = writer_.moves(path); // then a variable has all of it
        if (!moves)
            writer_.floats(variable_, numbers({glm::value_ptr(values), 16}, path));
        writer_.add({call(name),
                     plain("("),
                     {Part::Kind::Plain, variable_, moves ? path : std::string()},
                     plain(");")});
    }

    /// From eye coordinates to the light's picture: as a camera in its place would be set up, and then from
    /// -1 to 1 to 0 to 1.
    void lightView() {
        writer_.add("glTranslatef(0.5f, 0.5f, 0.5f);");
        writer_.add("glScalef(0.5f, 0.5f, 0.5f);");
        writeLightProjection(emission_);
        writeLightView(emission_, variable_);
    }

    Emission& emission_;
    CodeWriter& writer_;
    const MatrixStep& step_;
    std::string path_;
    std::string variable_;
    bool multiplies_;
};

bool flips(const Emission& emission, std::size_t pass, std::size_t unit) {
    return emission.lateFlips[pass][unit] == LateFlip::Matrix;
}

void loadStart(CodeWriter& writer, bool flips) {
    writer.add("glLoadIdentity();");
    if (flips) {
        writer.add("glTranslatef(0.0f, 1.0f, 0.0f); /* t becomes 1 - t: the image is upside down */");
        writer.add("glScalef(1.0f, -1.0f, 1.0f);");
    }
}

/// See app/render/texture_stacks.cpp.
void touch(CodeWriter& writer) {
    writer.add(
        "glTranslatef(0.0f, 0.0f, 0.0f); /* no change, but Mesa 22.3 forgets a matrix after others */");
}

/// The calls of steps on a stack. `isNew`: nothing but the start has been loaded.
class StackWriter {
public:
    StackWriter(Emission& emission, std::size_t pass, std::size_t unit, std::string variable)
        : emission_(emission)
        , pass_(pass)
        , unit_(unit)
        , variable_(std::move(variable))
        , flips_(flips(emission, pass, unit)) {}

    void write(const PlacedSteps& steps, bool isNew) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const bool keepsFlip = flips_ && steps[i].step->op == MatrixOp::Load;
            if (keepsFlip && !std::exchange(isNew, false))
                loadStart(emission_.writer, true);
            StepWriter(emission_, steps[i], unit_, variableOf(steps[i], i), keepsFlip).write();
        }
    }

private:
    [[nodiscard]] std::string variableOf(const PlacedStep& placed, std::size_t place) const {
        if (placed.pass != pass_)
            return fmt::format("{}Left{}", variable_, place);
        return placed.model ? fmt::format("{}Model{}Matrix{}", variable_, *placed.model, placed.index)
                            : fmt::format("{}Matrix{}", variable_, placed.index);
    }

    Emission& emission_;
    std::size_t pass_;
    std::size_t unit_;
    std::string variable_;
    bool flips_;
};

/// Lines between glMatrixMode(GL_TEXTURE) and glMatrixMode(GL_MODELVIEW), where there are any.
class TextureMode {
public:
    explicit TextureMode(Emission& emission)
        : emission_(emission) {}
    TextureMode(const TextureMode&) = delete;
    TextureMode& operator=(const TextureMode&) = delete;
    ~TextureMode() {
        if (isOpen_)
            emission_.writer.add(fmt::format("glMatrixMode({});", modelViewMode));
    }

    void select(std::size_t unit) {
        if (!std::exchange(isOpen_, true))
            emission_.writer.add(fmt::format("glMatrixMode({});", textureMode));
        if (std::exchange(emission_.activeUnit, static_cast<int>(unit)) != static_cast<int>(unit))
            emission_.writer.add(fmt::format("glActiveTexture({});", textureUnitName(unit)));
    }

private:
    Emission& emission_;
    bool isOpen_ = false;
};

void push(Emission& emission, std::size_t unit, std::vector<PushedMatrix>& pushed) {
    emission.writer.add("glPushMatrix();");
    pushed.push_back({unit, emission.stacks[unit]});
}

void pop(Emission& emission, std::vector<PushedMatrix>& pushed) {
    TextureMode mode(emission);
    for (PushedMatrix& each : pushed) {
        mode.select(each.unit);
        emission.writer.add("glPopMatrix();");
        emission.stacks[each.unit] = std::move(each.top);
    }
    pushed.clear();
}

} // namespace

std::string stepPath(const PlacedStep& placed, std::size_t unit) {
    return placed.model
               ? fmt::format("{}.{}.{}", elementOf<&Scene::models>(*placed.model),
                             elementOf<&Model::units>(unit), elementOf<&ModelUnit::matrix>(placed.index))
               : unitPath(placed.pass, unit, {elementOf<&Unit::matrix>(placed.index)});
}

bool anyMoves(const Emission& emission, const PlacedSteps& steps, std::size_t unit) {
    return std::ranges::any_of(steps, [&](const PlacedStep& placed) {
        return isMoving(*placed.step) || emission.keys.movesBelow(stepPath(placed, unit) + '.');
    });
}

bool modelsHaveSteps(const Scene& scene, std::size_t pass) {
    return std::ranges::any_of(drawnModels(scene, scene.passes[pass]), [&](std::size_t model) {
        return hasOwnSteps(scene.passes[pass], scene.models[model]);
    });
}

void writePassMatrix(Emission& emission, std::size_t pass, std::size_t unit, const std::string& variable) {
    const Scene& scene = emission.scene;
    const Unit& state = scene.passes[pass].units[unit];
    std::optional<StackTop>& top = emission.stacks[unit];
    StackTop next{flips(emission, pass, unit), inheritedSteps(scene, pass, unit)};
    const bool isThere = top == next;
    const bool isNew = state.matrixStart == MatrixStart::Identity;
    for (std::size_t p = 0; p < pass && !isNew; ++p) { // while it is off it would leave its steps
        const std::string switched = unitPath(p, unit, {keyOf<&Unit::enabled>()});
        if (emission.keys.moves(switched))
            emission.keys.refuse(switched);
    }
    emission.isFresh[unit] = true;
    const bool pushes = state.matrixStart == MatrixStart::Push;
    if (isThere && next == StackTop{} && state.matrix.empty() && !pushes)
        return;
    TextureMode mode(emission);
    mode.select(unit);
    if (pushes)
        push(emission, unit, emission.pushedByPass);
    StackWriter writer(emission, pass, unit, variable);
    if (isNew || !isThere) {
        loadStart(emission.writer, next.flips);
        pushSteps(scene, pass, unit, std::nullopt, next.steps);
        writer.write(next.steps, true);
    } else {
        if (state.matrix.empty() && next != StackTop{})
            touch(emission.writer);
        PlacedSteps own;
        pushSteps(scene, pass, unit, std::nullopt, own);
        writer.write(own, false);
        pushSteps(scene, pass, unit, std::nullopt, next.steps);
    }
    top = std::move(next);
}

void writeModelMatrices(Emission& emission, std::size_t pass, std::size_t model) {
    const Scene& scene = emission.scene;
    if (!modelsHaveSteps(scene, pass))
        return;
    const bool changes = emission.hasPopped || hasOwnSteps(scene.passes[pass], scene.models[model]);
    TextureMode mode(emission);
    for (std::size_t u = 0; u < maxUnits; ++u) {
        std::optional<StackTop>& top = emission.stacks[u];
        PlacedSteps own;
        pushSteps(scene, pass, u, model, own);
        const bool isForgotten = changes && !emission.isFresh[u] && top != StackTop{};
        if (!scene.passes[pass].units[u].enabled || (own.empty() && !isForgotten))
            continue;
        mode.select(u);
        if (own.empty())
            touch(emission.writer);
        else if (scene.models[model].pushMatrix)
            push(emission, u, emission.pushedByModel);
        StackWriter(emission, pass, u, joined(emission.passVariable(pass), fmt::format("unit{}", u)))
            .write(own, false);
        pushSteps(scene, pass, u, model, top->steps);
    }
}

void endModelMatrices(Emission& emission) {
    emission.hasPopped = !emission.pushedByModel.empty();
    emission.isFresh = {};
    pop(emission, emission.pushedByModel);
}

void endPassMatrices(Emission& emission) {
    emission.hasPopped = false;
    pop(emission, emission.pushedByPass);
}

} // namespace texplorer::emit

// Texture matrices, by OpenGL 2.1's calls: a stack for each unit.

#include "texplorer/emit/transformations.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

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
            MatrixCalls calls(emission_);
            addStep(emission_, calls, steps[i], unit_, variableOf(steps[i], i),
                    steps[i].step->op == MatrixOp::Load && !keepsFlip);
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
            emission.keys.refuse(switched, N_("a later pass goes on from its texture matrix"));
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

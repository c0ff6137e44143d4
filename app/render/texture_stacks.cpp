#include "app/render/texture_stacks.h"

#include "app/render/fixed_state.h"
#include "texplorer/scene/texture_matrix.h"

#include <GL/glew.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace texplorer::render {

namespace {

/// Sets t to r.
constexpr glm::mat4 rAsT{1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1};

void select(std::size_t unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glMatrixMode(GL_TEXTURE);
}

/// Multiplies by 1. Mesa 22.3 applies only those texture matrices that were multiplied or loaded since the
/// last one of any unit was: not one that glPopMatrix brought back.
void touch() {
    glTranslatef(0, 0, 0);
}

} // namespace

TextureStacks::TextureStacks(int units)
    : units_(static_cast<std::size_t>(std::clamp(units, 0, maxUnits))) {}

TextureStacks::Start TextureStacks::startOf(const BoundTexture& texture, Target target) {
    return {texture.compares && target == Target::Texture1D, texture.lateFlip == LateFlip::Matrix};
}

void TextureStacks::load(const Start& start) {
    glLoadIdentity();
    if (start.comparesLine) // Mesa 22.3 compares this coordinate; otherwise a line never requests t
        glMultMatrixf(glm::value_ptr(rAsT));
    if (start.flips) {
        glTranslatef(0, 1, 0);
        glScalef(1, -1, 1);
    }
}

void TextureStacks::multiply(const PlacedSteps& steps, std::size_t unit, double time, const Light& light) {
    for (const PlacedStep& placed : steps) {
        if (placed.step->op == MatrixOp::Load)
            load(starts_[unit]);
        applyMatrixStep(*placed.step, time, light);
    }
}

void TextureStacks::push(std::size_t unit, std::vector<Pushed>& pushed) {
    glPushMatrix();
    pushed.push_back({unit, starts_[unit]});
}

void TextureStacks::pop(std::vector<Pushed>& pushed) {
    if (pushed.empty())
        return;
    for (const Pushed& each : pushed) {
        select(each.unit);
        glPopMatrix();
        starts_[each.unit] = each.start;
    }
    pushed.clear();
    glMatrixMode(GL_MODELVIEW);
}

void TextureStacks::beginFrame() {
    endModel(); // a frame that was not finished may have left them
    endPass();
    for (std::size_t u = 0; u < units_; ++u) {
        select(u);
        glLoadIdentity();
    }
    starts_ = {};
    glMatrixMode(GL_MODELVIEW);
}

void TextureStacks::beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures,
                              double time) {
    const Pass& drawn = scene.passes[pass];
    for (std::size_t u = 0; u < units_; ++u) {
        const Unit& unit = drawn.units[u];
        if (!unit.enabled)
            continue;
        select(u);
        if (unit.matrixStart == MatrixStart::Push)
            push(u, byPass_);
        const Start start = startOf(textures[u], unit.target);
        PlacedSteps steps;
        if (unit.matrixStart == MatrixStart::Identity || start != starts_[u]) {
            load(start);
            steps = inheritedSteps(scene, pass, u);
        } else
            touch();
        starts_[u] = start;
        pushSteps(scene, pass, u, std::nullopt, steps);
        multiply(steps, u, time, scene.light);
    }
    modelsHaveSteps_ = modelsHaveSteps(scene, pass);
    glMatrixMode(GL_MODELVIEW);
}

void TextureStacks::beginModel(const Scene& scene, std::size_t pass, std::size_t model, double time) {
    if (!modelsHaveSteps_)
        return;
    for (std::size_t u = 0; u < units_; ++u) {
        if (!scene.passes[pass].units[u].enabled)
            continue;
        select(u);
        PlacedSteps steps;
        pushSteps(scene, pass, u, model, steps);
        if (steps.empty())
            touch();
        else if (scene.models[model].pushMatrix)
            push(u, byModel_);
        multiply(steps, u, time, scene.light);
    }
    glMatrixMode(GL_MODELVIEW);
}

void TextureStacks::endModel() {
    pop(byModel_);
}

void TextureStacks::endPass() {
    pop(byPass_);
}

} // namespace texplorer::render

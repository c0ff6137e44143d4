#pragma once

#include "app/render/texture_cache.h"
#include "texplorer/scene/scene.h"

namespace texplorer::render {

// Sets the fixed-function state of a Scene. All functions expect GL's initial state: see StateGuard.

/// Sets GL_LIGHT0 and the light model. The modelview matrix must be the identity, because the light's
/// position is in eye coordinates.
void applyLight(const Light& light);

/// Sets GL_PROJECTION by glFrustum or glOrtho. All matrices in this file are made by the calls that a program
/// would make: the output of core/emit draws identical pixels.
void applyProjection(const View& view, float aspect);

/// Sets GL_MODELVIEW for a model at `time`: the camera's calls, unless the model moves with the eye, and the
/// model's own.
void applyModelView(const View& view, const Model& model, double time);

/// Sets the material and the current colour.
void applyMaterial(const Material& material);

/// Sets lighting, the alpha test and fog.
void applyFixedPass(const Pass& pass);

/// Sets the texture bound to one unit, its environment and the coordinates that it generates. The modelview
/// matrix must be the identity, because eye planes are in eye coordinates.
void applyUnit(int index, const Unit& unit, const BoundTexture& texture);

/// Multiplies the current matrix by a step at `time`. A step that loads a matrix multiplies, too.
void applyMatrixStep(const MatrixStep& step, double time, const Light& light);

void switchUnitOff(int index);

} // namespace texplorer::render

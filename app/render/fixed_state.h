#pragma once

#include "app/render/texture_cache.h"
#include "core/scene/scene.h"

namespace texplorer::render {

// What a Scene says, as fixed-function state. All of it begins with GL's initial values: see StateGuard.

/// GL_LIGHT0 and the light model. The modelview matrix must be the identity: the light stands in eye
/// coordinates.
void applyLight(const Light& light);

/// GL_PROJECTION: glFrustum or glOrtho. Like all matrices of this file it comes about by the calls that a
/// program makes: what core/emit writes draws the very same pixels.
void applyProjection(const View& view, float aspect);

/// GL_MODELVIEW of a model at `time`: the camera's calls, unless the model moves with the eye, and its own.
void applyModelView(const View& view, const Model& model, double time);

/// The material and the current colour.
void applyMaterial(const Material& material);

/// Lighting on or off, the alpha test and fog.
void applyFixedPass(const Pass& pass);

/// The texture bound to one unit, its environment and its matrix at `time`; with LateFlip::Matrix the matrix
/// begins with t -> 1 - t. The modelview matrix must be the identity: eye planes are in eye coordinates.
void applyUnit(int index, const Unit& unit, const BoundTexture& texture, double time, const Light& light);

void switchUnitOff(int index);

} // namespace texplorer::render

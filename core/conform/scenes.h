#pragma once

// The scenes of each feature, for its row in features.cpp.

#include "texplorer/conform/dice.h"
#include "texplorer/scene/scene.h"

namespace texplorer::conform::scenes {

// Coverage and colours.
Scene coverage(int number, Dice& state, Dice& values);
Scene depth(int number, Dice& state, Dice& values);
Scene lighting(int number, Dice& state, Dice& values);
Scene separateSpecular(int number, Dice& state, Dice& values);
Scene twoSided(int number, Dice& state, Dice& values);
Scene fog(int number, Dice& state, Dice& values);

// Models: primitives and positions.
Scene lines(int number, Dice& state, Dice& values);
Scene meshes(int number, Dice& state, Dice& values);
Scene quadrics(int number, Dice& state, Dice& values);
Scene materials(int number, Dice& state, Dice& values);
Scene placement(int number, Dice& state, Dice& values);
Scene emboss(int number, Dice& state, Dice& values);

// Texture coordinates.
Scene wrap(int number, Dice& state, Dice& values);
Scene wrapLinear(int number, Dice& state, Dice& values);
Scene linearTexGen(int number, Dice& state, Dice& values);
Scene mappedTexGen(int number, Dice& state, Dice& values);
Scene texGenOnShapes(int number, Dice& state, Dice& values);
Scene matrix(int number, Dice& state, Dice& values);
Scene matrixStack(int number, Dice& state, Dice& values);
Scene projector(int number, Dice& state, Dice& values);
Scene subimages(int number, Dice& state, Dice& values);
Scene pictures(int number, Dice& state, Dice& values);

// Filters.
Scene nearest(int number, Dice& state, Dice& values);
Scene linear(int number, Dice& state, Dice& values);
Scene magnification(int number, Dice& state, Dice& values);
Scene mipmapNearest(int number, Dice& state, Dice& values);
Scene trilinear(int number, Dice& state, Dice& values);
Scene lodOfOneLevel(int number, Dice& state, Dice& values);
Scene lodOfTwoLevels(int number, Dice& state, Dice& values);
Scene levelSettings(int number, Dice& state, Dice& values);
Scene anisotropy(int number, Dice& state, Dice& values);
Scene targets(int number, Dice& state, Dice& values);
Scene cubeMap(int number, Dice& state, Dice& values);
Scene seamless(int number, Dice& state, Dice& values);
Scene border(int number, Dice& state, Dice& values);
Scene hint(int number, Dice& state, Dice& values);
Scene compression(int number, Dice& state, Dice& values);
Scene incomplete(int number, Dice& state, Dice& values);
Scene givenLevels(int number, Dice& state, Dice& values);

// Formats, environments and per-fragment operations.
Scene internalFormats(int number, Dice& state, Dice& values);
Scene depthTextures(int number, Dice& state, Dice& values);
Scene preparation(int number, Dice& state, Dice& values);
Scene floatFormats(int number, Dice& state, Dice& values);
Scene upload(int number, Dice& state, Dice& values);
Scene environment(int number, Dice& state, Dice& values);
Scene combine(int number, Dice& state, Dice& values);
Scene units(int number, Dice& state, Dice& values);
Scene alphaTest(int number, Dice& state, Dice& values);
Scene blend(int number, Dice& state, Dice& values);
Scene passes(int number, Dice& state, Dice& values);

// All features together.
Scene mixture(int number, Dice& state, Dice& values);

} // namespace texplorer::conform::scenes

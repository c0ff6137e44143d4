#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/scene/params/params.h"

#include <string>

namespace texplorer::ui {

struct Session;

/// The range of dragged coordinates; `step` is a drag of one pixel in the list.
inline constexpr Range coordRange{-1000, 1000, 0.005F, {}};

[[nodiscard]] glm::vec4 withinCoordRange(glm::vec4 coord); ///< 0 for what is not a number

/// "models[0].texCoords1" of the selected model and unit.
[[nodiscard]] std::string coordsPath(const Session& session);

/// Submits a step that sets the coordinates of the selected model and unit, within the range; empty: those of
/// the mesh.
void submitTexCoords(const Session& session, Sentence name, TexCoords coords);
/// A part of a drag, with any coordinates.
void dragTexCoords(const Session& session, Sentence name, TexCoords coords);

/// Submits a step that leaves out the vertex's glTexCoord for the selected model and unit, or sends it again.
void submitLeftOut(const Session& session, std::size_t vertex, bool leftOut);

/// Submits a step that resets the coordinates of the selected model and unit to those of the mesh, and sends
/// all of them.
void resetTexCoords(const Session& session);

// The actions of the buttons above the vertex list, on all coordinates of a model. r and q stay unchanged.

void scaleCoords(TexCoords& coords, float factor); ///< about (0, 0): 2 shows the image twice as often
void flipS(TexCoords& coords);                     ///< s becomes 1 - s
void flipT(TexCoords& coords);
void rotateQuarter(TexCoords& coords); ///< by 90 degrees counter-clockwise about (0.5, 0.5)

} // namespace texplorer::ui

#pragma once

// The sections of the panel, and their parts: each draws the rows of what is selected.

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The most important parameters, one click each, and below them the rows that the user has pinned.
void essentials(const Session& session, const Pictures& pictures);

/// The texture bound to the selected unit.
void textureSection(const Session& session, const Pictures& pictures);

/// The built-in patterns as small pictures, next to them the texture's previous image file, and a button that
/// opens one. For the bound texture, which must exist.
void imageChoice(const Session& session, const Pictures& pictures);

/// The equation of the selected unit's environment, and its input and output colours, for the probed pixel or
/// for reference colours: glColor and the mean of the image. Uses the previewed scene, if any.
void environmentLine(const Session& session);

void combineSection(const Session& session);     ///< of the selected unit, whose mode is GL_COMBINE
void coordinatesSection(const Session& session); ///< generated ones, of the selected unit

/// The steps of the selected unit's texture matrix.
void matrixSection(const Session& session);

/// The presets that move the texture, one click each, and a button that adds a step.
void motionButtons(const Session& session);

/// Buttons to select the pass whose units and state are shown; a dot marks those that are drawn. Does nothing
/// if there is one pass.
void passChoice(const Session& session);

/// The passes: add, remove, reorder; and the state of the selected one.
void passSection(const Session& session);

/// The selected model: the choice, number and order of models, and its rows of the tables.
void modelSection(const Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

// Edits of the levels that are read. Each records its edit; the caller seals a drag at its end.

inline constexpr int noMaxLevel = 1000; ///< GL's initial values: no limit
inline constexpr float noMinLod = -1000;
inline constexpr float noMaxLod = 1000;

/// Reads only this level; if it is the only one already, restores the previous range.
void toggleForced(Session& session, int level);
/// Call once per frame, before the docks: forgets the previous range if the bound texture has changed, or if
/// it reads other levels.
void followForced(Session& session);

void setBaseLevel(const Session& session, int level);
void setMaxLevel(const Session& session, int level);
void setMinLod(const Session& session, float lod);
void setMaxLod(const Session& session, float lod);
void setTextureBias(const Session& session, float bias);
void setUnitBias(const Session& session, float bias);

/// Whether base and max level, the limits of λ or a bias differ from GL's initial values.
[[nodiscard]] bool limitsLevels(const Session& session);
/// Restores those; one undo step.
void readAllLevels(const Session& session);

/// GL_TEXTURE_LOD_BIAS of the texture and of the unit.
[[nodiscard]] float biasOf(const Session& session);

} // namespace texplorer::ui

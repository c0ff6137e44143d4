#pragma once

#include "app/ui/details/levels_tab.h"

namespace texplorer::ui {

// What one changes of the levels that are read. Each records its edit; a drag is sealed by who sees it end.

inline constexpr int noMaxLevel = 1000; ///< GL's initial values: no limit
inline constexpr float noMinLod = -1000;
inline constexpr float noMaxLod = 1000;

/// The level alone is read; if it is the only one already, those from before are read again.
void toggleForced(Session& session, int level);
/// To be called in every frame: what was before is forgotten where the bound texture is another one, or reads
/// other levels by now.
void followForced(Session& session);

void setBaseLevel(Session& session, int level);
void setMaxLevel(Session& session, int level);
void setMinLod(Session& session, float lod);
void setMaxLod(Session& session, float lod);
void setTextureBias(Session& session, float bias);
void setUnitBias(Session& session, float bias);

/// Whether base and max level, the limits of λ or a bias differ from GL's initial values.
[[nodiscard]] bool limitsLevels(const Session& session);
/// Gives them those; one step of undo.
void readAllLevels(Session& session);

/// GL_TEXTURE_LOD_BIAS of the texture and of the unit.
[[nodiscard]] float biasOf(const Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// What the selected unit's environment computes, as an equation, and the colours that go into it and come
/// out, of the probed pixel or of a reference colour: glColor and the mean of the image. What is previewed
/// counts.
void environmentLine(Session& session);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "core/reference/explain/explanation_steps.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// What the reference and the pictures have at the pixel.
struct Comparison {
    std::vector<reference::StepRow> rows;
    std::vector<std::string> compared; ///< labels of the renderers that are held against the reference
    int most = 0;                      ///< the largest difference that is no tie
};

/// Of the explained pixel. While the answer is about an earlier picture, nothing is compared.
[[nodiscard]] Comparison compareRenderers(const Session& session, const Pictures& pictures,
                                          const reference::Explanation& explanation);

/// Whether the method of the anisotropic filter may be all that differs.
[[nodiscard]] bool mayDifferByMethod(const Session& session, const reference::Explanation& explanation);

} // namespace texplorer::ui

#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "texplorer/reference/explain/explanation_steps.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// The colours of the reference and of the pictures at the pixel.
struct Comparison {
    std::vector<reference::StepRow> rows;
    std::vector<std::string> compared; ///< labels of the renderers that are compared with the reference
    int most = 0;                      ///< the largest difference that is not a tie
};

/// For the explained pixel. Nothing is compared while the answer belongs to an earlier picture.
[[nodiscard]] Comparison compareRenderers(const Session& session, const Pictures& pictures,
                                          const reference::Explanation& explanation);

/// Whether the method of the anisotropic filter may be the only difference.
[[nodiscard]] bool mayDifferByMethod(const Session& session, const reference::Explanation& explanation);

} // namespace texplorer::ui

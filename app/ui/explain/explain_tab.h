#pragma once

#include "app/ui/explain/explain_pipeline.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The texts of an answer, made only once: an average over an ellipse has thousands of texels.
struct AnswerSteps {
    std::shared_ptr<const reference::ProbeWorker::Answer> answer;
    std::vector<reference::FragmentSteps> steps;

    /// For an answer with an explanation.
    const std::vector<reference::FragmentSteps>&
    of(const std::shared_ptr<const reference::ProbeWorker::Answer>& asked) {
        if (answer != asked)
            steps = reference::stepsOf(**asked->explanation);
        answer = asked;
        return steps;
    }
};

/// The state of the tab.
struct ExplainTabState {
    OpenCards open;
    std::size_t fragment =
        0; ///< the fragment whose cards are shown, of the pixel `fragmentOf`; else the visible one
    std::optional<reference::PixelPlace> fragmentOf;
    AnswerSteps steps;
    AnswerSteps pinnedSteps;
};

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

/// Draws a pipeline from left to right if the panel is wide, else a list.
void drawExplainTab(const Session& session, ExplainTabState& state, const Pictures& pictures);

} // namespace texplorer::ui

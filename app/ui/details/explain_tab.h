#pragma once

#include "app/ui/details/explain_pipeline.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The words of an answer, which are made once: an average over an ellipse alone has thousands of texels.
struct AnswerSteps {
    std::shared_ptr<const reference::ProbeWorker::Answer> answer;
    std::vector<reference::FragmentSteps> steps;

    /// Of an answer with an explanation.
    const std::vector<reference::FragmentSteps>&
    of(const std::shared_ptr<const reference::ProbeWorker::Answer>& asked) {
        if (answer != asked)
            steps = reference::stepsOf(**asked->explanation);
        answer = asked;
        return steps;
    }
};

/// What the tab remembers.
struct ExplainTabState {
    PipelineState pipeline;
    std::size_t fragment = 0; ///< the one whose cards are shown, of the pixel `fragmentOf`; else the seen one
    std::optional<reference::PixelPlace> fragmentOf;
    AnswerSteps steps;
    AnswerSteps pinnedSteps;
};

/// As a pipeline from left to right where the panel is wide, else as a list.
void drawExplainTab(Session& session, ExplainTabState& state, const Pictures& pictures);

} // namespace texplorer::ui

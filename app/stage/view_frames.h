#pragma once

#include "app/stage/graphics.h"
#include "app/ui/model/session.h"
#include "app/ui/state/view_frame.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/light_depth.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::stage {

/// The pictures of the view, by all the renderers that it shows.
class ViewFrames {
public:
    /// `graphics` must outlive it.
    explicit ViewFrames(Graphics& graphics)
        : graphics_(graphics) {}

    /// Call once per frame, before the panels are drawn: the frames are valid until the next call.
    void draw(ui::Session& session, view::Size size);

    /// The scene's images as they were drawn, including the light's view.
    [[nodiscard]] const ImageSource& images() const { return images_; }

    /// In the order of ui::shownRenderers; with Arrangement::Kept the last one is A's. Never empty after
    /// `draw`.
    [[nodiscard]] const std::vector<ui::ViewFrame>& frames() const { return frames_; }

    /// The difference of the two compared frames; nullptr: none are compared, or one of them is not complete.
    [[nodiscard]] const ui::ViewDifference* difference() const {
        return difference_ ? &*difference_ : nullptr;
    }

    /// The programs of each pass; empty if no panel shows them.
    [[nodiscard]] const std::vector<std::shared_ptr<const view::PassShader>>& shaders() const {
        return shaders_;
    }

    /// The problems of all renderers, each sentence once.
    [[nodiscard]] const std::vector<Sentence>& problems() const { return problems_; }

    /// Whether an upload continues in the next frame.
    [[nodiscard]] bool isUnfinished() const;

private:
    /// The pixels of a host's renderer, as they were last read.
    struct Pixels {
        std::uint64_t revision = 0;
        std::shared_ptr<const Image> image;
    };

    /// The scene of one side.
    struct Subject {
        view::Side side;
        const Scene& scene;
        const ImageSource& images;
    };

    void addDrawnImages(const ui::Session& session);
    [[nodiscard]] ui::ViewFrame draw(RendererKind kind, const Subject& subject, ui::Session& session,
                                     view::Size size);
    [[nodiscard]] ui::ViewFrame drawLive(RendererKind kind, const Subject& subject, ui::Session& session,
                                         view::Size size);
    [[nodiscard]] ui::ViewFrame drawReference(const Subject& subject, ui::Session& session, view::Size size);
    void keepStepPicture(ui::Session& session);
    void addProblems(const std::vector<Sentence>& problems);
    void compareViews(const ui::ViewSettings& settings);

    Graphics& graphics_;
    reference::LightDepths lightDepths_;
    reference::ReferenceRenderer reference_; ///< draws pictures that only the panels show
    ImageSource images_;
    std::map<std::pair<view::Side, RendererKind>, Pixels> pixels_;
    std::vector<ui::ViewFrame> frames_;
    std::optional<ui::ViewDifference> difference_;
    std::array<std::shared_ptr<const Image>, 2> compared_; ///< the inputs of the difference
    std::shared_ptr<const Image> heatMap_;
    std::vector<Sentence> problems_;
    std::vector<std::shared_ptr<const view::PassShader>> shaders_;
};

} // namespace texplorer::stage

#pragma once

// What a worker process of `texshot test` does.

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/runs/work_order.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/plan.h"

#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace texplorer::screenshot {

/// Follows orders, one after the other. The plan, OpenGL and the images of the last scene stay from one to
/// the next.
class CaseWorker {
public:
    /// Bytes of an order in, bytes of an answer out.
    [[nodiscard]] std::string work(const std::string& order);

private:
    [[nodiscard]] WorkAnswer follow(const WorkOrder& order);
    [[nodiscard]] WorkAnswer openDriver(const WorkOrder& order);
    [[nodiscard]] WorkAnswer doCase(const WorkOrder& order);
    [[nodiscard]] WorkAnswer judge(const WorkOrder& order, const suite::Case& of, Frame frame,
                                   const suite::CaseScene& scene, const conform::Driver& driver);
    [[nodiscard]] Result<void> plan(const RunSetup& setup);
    [[nodiscard]] Result<Studio*> studio(const RunSetup& setup);
    [[nodiscard]] Result<suite::CaseScene> openScene(const suite::Case& of);
    [[nodiscard]] Result<Frame> draw(const RunSetup& setup, const suite::Case& of,
                                     const suite::CaseScene& scene);

    RunSetup planned_; ///< what plan_ is of
    std::optional<suite::Plan> plan_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<suite::Fingerprints> fingerprints_;

    using ScenePlace = std::tuple<std::size_t, std::size_t, std::size_t>; ///< suite, entry, scene
    std::optional<ScenePlace> loaded_;
    ImageSource images_; ///< of that one
};

/// What a fingerprint of a case says of who drew it and how, beside the driver's name.
[[nodiscard]] std::string drawnWith(const RunSetup& setup, std::string_view driverVersion);

} // namespace texplorer::screenshot

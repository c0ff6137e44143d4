#pragma once

#include "app/render/render_target.h"
#include "app/render/texture_object.h"
#include "app/view/capabilities.h"
#include "app/view/texture_cost.h"

#include <array>
#include <memory>
#include <optional>

namespace texplorer::render {

/// Measures view::costRows with fixed function, into a framebuffer of its own. Belongs to the current
/// context, whose state is unchanged between the calls.
class CostMeter final : public view::CostMeter {
public:
    CostMeter(view::Capabilities capabilities, view::CostSubject subject, std::size_t pairs);

    [[nodiscard]] bool measure(view::TextureCosts& costs, std::chrono::milliseconds time) override;

private:
    /// A variant of the present row.
    struct Prepared {
        bool uploads = false;
        Target target = Target::Texture2D;
        std::shared_ptr<const PreparedLevels> levels;
        TextureObject object;
        int repeats = 0;      ///< in a sample; 0: it has not been drawn yet
        bool isTried = false; ///< the repeats are enough
    };

    [[nodiscard]] Result<void> prepare(const view::CostRow& row);
    [[nodiscard]] Result<Prepared> prepare(const view::CostVariant& variant, bool ofScene);
    [[nodiscard]] Result<void> advance(const view::CostRow& row, PairedTimes& times);
    /// The seconds that a repeat takes, the mean of a sample.
    [[nodiscard]] double timeOf(const view::CostRow& row, Prepared& variant);

    view::Capabilities capabilities_;
    view::CostSubject subject_;
    std::size_t pairs_;
    RenderTarget target_;
    std::size_t row_ = 0;
    std::optional<std::array<Prepared, 2>> prepared_; ///< of that row
    GlErrors errors_;
};

} // namespace texplorer::render

#pragma once

#include "texplorer/compare/difference.h"
#include "texplorer/conform/pair.h"
#include "texplorer/conform/renderer.h"
#include "texplorer/conform/rule.h"

#include <optional>
#include <vector>

namespace texplorer::conform {

/// Which values in rho's range (OpenGL 2.1, section 3.8.8) a driver may use: the ideal rho or one end of the
/// range for the whole picture, or any value.
enum class RhoRange : std::uint8_t { Ends, Any };

/// Ends for known drivers: llvmpipe uses the ideal rho, or the largest derivative without
/// GALLIVM_PERF=no_rho_approx, as does softpipe.
[[nodiscard]] RhoRange rhoRangeOf(const Driver& driver);

struct Judgement {
    Difference difference; ///< above the rule's bound
    /// Of these pixels, those that exceed the rule's tolerance, too. If lambda's error would have to be
    /// computed for more than a 32nd of the picture, that many evenly spaced pixels are sampled and scaled
    /// up.
    std::size_t unexplained = 0;
    /// Of these pixels, those that a rho strictly inside the range of OpenGL 2.1, section 3.8.8, other than
    /// the ideal one, explains; sampled likewise.
    std::size_t withinRho = 0;
    std::size_t far = 0; ///< pixels above the rule's farBound
    /// How the driver computes rho: by an end of that range if the reference matches better then.
    reference::RhoMethod rho = reference::RhoMethod::Ideal;
    std::optional<Image> redrawn{}; ///< the picture that it was compared with in that case, instead of `ours`

    [[nodiscard]] double shareUnexplained() const { return share(unexplained); }
    [[nodiscard]] double shareFar() const { return share(far); }
    /// Whether a rule allows this much in a single scene.
    [[nodiscard]] bool isAllowed(const Rule& rule) const {
        return shareUnexplained() <= 1 - rule.explainedScene && shareFar() <= 1 - rule.nearScene;
    }

private:
    [[nodiscard]] double share(std::size_t count) const {
        return difference.pixels == 0 ? 0
                                      : static_cast<double>(count) / static_cast<double>(difference.pixels);
    }
};

/// Judges two pictures of a scene by a rule. `ours` is the reference's picture; `reference` draws what the
/// rule's tolerance allows. Errors: those of compare() and of drawing.
[[nodiscard]] Result<Judgement> judge(const Rule& rule, const Scene& scene, const Image& ours,
                                      const Image& theirs, Explainer& reference,
                                      RhoRange range = RhoRange::Ends);

/// Returns the scene with all coordinates moved by 1/128 of a texel of these images, in four directions; or
/// by 2^-20 of the largest coordinate if that is more, as only so many of its bits are exact.
[[nodiscard]] std::vector<Scene> movedByTexelError(const Scene& scene, const ImageSource& images);

} // namespace texplorer::conform

#pragma once

#include "core/compare/difference.h"
#include "core/conform/pair.h"
#include "core/conform/renderer.h"
#include "core/conform/rule.h"

#include <optional>
#include <vector>

namespace texplorer::conform {

/// What of rho's range (OpenGL 2.1, section 3.8.8) a driver may take: the ideal rho or an end of the range in
/// the whole picture, or anything within it.
enum class RhoRange : std::uint8_t { Ends, Any };

/// Ends of the drivers that are known: llvmpipe takes the ideal rho, or the largest derivative without
/// GALLIVM_PERF=no_rho_approx, as softpipe does.
[[nodiscard]] RhoRange rhoRangeOf(const Driver& driver);

struct Judgement {
    Difference difference; ///< over the rule's bound
    /// Of these pixels, those that the rule's tolerance doesn't allow either. Where lambda's error would have
    /// to be asked for at more than a 32nd of the picture, it is at as many pixels evenly spaced, which
    /// stand for the others.
    std::size_t unexplained = 0;
    /// Of these pixels, those that are explained by a rho within the range of OpenGL 2.1, section 3.8.8,
    /// which is neither the ideal one nor an end of the range; counted likewise.
    std::size_t withinRho = 0;
    std::size_t far = 0; ///< pixels over the rule's farBound
    /// How the driver computes rho: at an end of that range where the reference is nearer to it then.
    reference::RhoMethod rho = reference::RhoMethod::Ideal;
    std::optional<Image> redrawn{}; ///< the picture that it was held against then, instead of `ours`

    [[nodiscard]] double shareUnexplained() const { return share(unexplained); }
    [[nodiscard]] double shareFar() const { return share(far); }
    /// Whether a rule allows a single scene so much.
    [[nodiscard]] bool isAllowed(const Rule& rule) const {
        return shareUnexplained() <= 1 - rule.explainedScene && shareFar() <= 1 - rule.nearScene;
    }

private:
    [[nodiscard]] double share(std::size_t count) const {
        return difference.pixels == 0 ? 0
                                      : static_cast<double>(count) / static_cast<double>(difference.pixels);
    }
};

/// Holds two pictures of a scene against a rule. `ours` is what the reference drew; `reference` draws what
/// the rule's tolerance allows. Errors: those of compare() and of the drawing.
[[nodiscard]] Result<Judgement> judge(const Rule& rule, const Scene& scene, const Image& ours,
                                      const Image& theirs, Explainer& reference,
                                      RhoRange range = RhoRange::Ends);

/// The scene with all coordinates moved by 1/128 of a texel of these images, in four directions; by 2^-20 of
/// the farthest coordinate where that is more, for so many bits of it are certain.
[[nodiscard]] std::vector<Scene> movedByTexelError(const Scene& scene, const ImageSource& images);

} // namespace texplorer::conform

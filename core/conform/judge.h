#pragma once

#include "core/compare/difference.h"
#include "core/conform/renderer.h"
#include "core/conform/rule.h"

#include <vector>

namespace texplorer::conform {

struct Judgement {
    Difference difference; ///< over the rule's bound
    /// Of these pixels, those that the rule's tolerance doesn't allow either. Above a sixteenth of the
    /// picture lambda's error is no longer asked for.
    std::size_t unexplained = 0;
};

/// Holds two pictures of a scene against a rule. `ours` is what the reference drew; `reference` draws what
/// the rule's tolerance allows. Errors: those of compare() and of the drawing.
[[nodiscard]] Result<Judgement> judge(const Rule& rule, const Scene& scene, const Image& ours,
                                      const Image& theirs, Explainer& reference);

/// The scene with all coordinates moved by 1/128 of a texel of these images, in four directions; by 2^-20 of
/// the farthest coordinate where that is more, for so many bits of it are certain.
[[nodiscard]] std::vector<Scene> movedByTexelError(const Scene& scene, const ImageSource& images);

} // namespace texplorer::conform

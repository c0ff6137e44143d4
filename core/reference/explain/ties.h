#pragma once

// Ties: where rounding decides which texels a sample reads, several results are correct.

#include "texplorer/reference/sampling/sample_record.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// A choice that changes if coordinates change by 1e-5 of their value, which OpenGL 2.1, 2.1.1 allows for
/// every operation, or lambda by 1/64, which dEQP allows (lodBits = 6).
struct Tie {
    enum class Between : std::uint8_t {
        Texels,  ///< under GL_NEAREST, for an axis of a level
        Levels,  ///< under GL_..._MIPMAP_NEAREST
        Filters, ///< magnification or minification
        Faces,   ///< of a cube map
    };
    Between between = Between::Texels;
    int chosen = 0; ///< index, level or face; for Filters the level
    int other = 0;  ///< the other correct choice
    int level = 0;  ///< for Texels
    int axis = 0;   ///< for Texels: 0 for s

    bool operator==(const Tie&) const = default;
};

struct Ties {
    std::vector<Tie> ties;
    std::vector<Tap> others; ///< texels that are read only with the other choice; the first few
};

/// The ties of a sample that explainSample made with the other arguments.
[[nodiscard]] Ties tiesOf(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                          const SampleOptions& options, const SampleRecord& sample);

/// Which of s, t, r and lambda must change to decide ties differently.
[[nodiscard]] glm::bvec4 tiedIn(const std::vector<Tie>& ties, Target target);

/// All combinations of rounding: a sign for each tied value, 0 for the others.
[[nodiscard]] std::vector<glm::vec4> roundingsOf(glm::bvec4 tied);

/// Returns coordinates, and the bias of lambda, moved beyond all ties in the direction of these signs.
[[nodiscard]] glm::vec3 rounded(Target target, glm::vec3 coords, glm::vec4 signs);
[[nodiscard]] SampleOptions rounded(SampleOptions options, glm::vec4 signs);

} // namespace texplorer::reference

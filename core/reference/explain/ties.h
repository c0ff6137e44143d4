#pragma once

// Where rounding decides which texels a sample reads: on a tie one answer is as right as the other.

#include "core/reference/sampling/sample_record.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// A choice that falls otherwise where coordinates differ by 1e-5 of themselves, which OpenGL 2.1, 2.1.1
/// allows every operation, or lambda by 1/64, which dEQP allows (lodBits = 6).
struct Tie {
    enum class Between : std::uint8_t {
        Texels,  ///< under GL_NEAREST, of an axis of a level
        Levels,  ///< under GL_..._MIPMAP_NEAREST
        Filters, ///< of magnification and minification
        Faces,   ///< of a cube map
    };
    Between between = Between::Texels;
    int chosen = 0; ///< index, level or face; of Filters the level
    int other = 0;  ///< what is as right
    int level = 0;  ///< of Texels
    int axis = 0;   ///< of Texels: 0 for s

    bool operator==(const Tie&) const = default;
};

struct Ties {
    std::vector<Tie> ties;
    std::vector<Tap> others; ///< the texels that a sample reads then and not now, the first few
};

/// Of a sample that explainSample has made with the other arguments.
[[nodiscard]] Ties tiesOf(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                          const SampleOptions& options, const SampleRecord& sample);

/// Which of s, t, r and lambda have to change so that ties fall otherwise; 0: it hasn't to.
[[nodiscard]] glm::bvec4 tiedIn(const std::vector<Tie>& ties, Target target);

/// Every way in which these may be rounded: a sign for each, 0 for what isn't tied.
[[nodiscard]] std::vector<glm::vec4> roundingsOf(glm::bvec4 tied);

/// Coordinates, and the bias of lambda, beyond any tie in the direction of these signs.
[[nodiscard]] glm::vec3 rounded(Target target, glm::vec3 coords, glm::vec4 signs);
[[nodiscard]] SampleOptions rounded(SampleOptions options, glm::vec4 signs);

} // namespace texplorer::reference

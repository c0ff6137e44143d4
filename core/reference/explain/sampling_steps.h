#pragma once

#include "core/reference/explain/explanation_steps.h"

namespace texplorer::reference {

/// From texture coordinates to a filtered colour: four steps.
[[nodiscard]] std::vector<Step> samplingSteps(const FragmentExplanation& fragment,
                                              const UnitExplanation& unit);

/// Lambda, with as many digits as tell on which side it is of what decides.
[[nodiscard]] std::string lambdaText(const Lod& lod);

/// Why the sample is magnified or minified, as a sentence.
[[nodiscard]] std::string whyMagnified(const UnitExplanation& unit);

/// The taps with those of one texel added up, the heaviest first where there are many.
[[nodiscard]] std::vector<Tap> mergedTaps(const SampleRecord& sample);

/// How many texels were read: one that several taps read, or a wrap mode makes of several, counts once.
[[nodiscard]] std::size_t texelCount(const SampleRecord& sample);

} // namespace texplorer::reference

#pragma once

#include "texplorer/reference/explain/explanation_steps.h"

namespace texplorer::reference {

/// The four steps from texture coordinates to a filtered colour.
[[nodiscard]] std::vector<Step> samplingSteps(const FragmentExplanation& fragment,
                                              const UnitExplanation& unit);

/// Lambda, with enough digits to show on which side of a limit it is.
[[nodiscard]] std::string lambdaText(const Lod& lod);

/// Why the sample is magnified or minified, as a sentence.
[[nodiscard]] Sentence whyMagnified(const UnitExplanation& unit);

/// Merges taps of the same texel; if there are many, sorted by weight.
[[nodiscard]] std::vector<Tap> mergedTaps(const SampleRecord& sample);

/// The number of different texels that were read: a texel that several taps read, also because of wrapping,
/// counts once.
[[nodiscard]] std::size_t texelCount(const SampleRecord& sample);

} // namespace texplorer::reference

#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/scene/renderer.h"

#include <array>
#include <utility>

namespace texplorer::view {

/// The renderers that a host has, and why it lacks the others. The reference is always there.
class OfferedRenderers {
public:
    /// `reason` says what is missing, as a sentence without its full stop.
    void withhold(RendererKind kind, Sentence reason) {
        reasons_[static_cast<std::size_t>(kind)] = std::move(reason);
    }

    [[nodiscard]] bool has(RendererKind kind) const {
        return kind == RendererKind::Reference || whyNot(kind).empty();
    }
    /// Empty where it is there.
    [[nodiscard]] const Sentence& whyNot(RendererKind kind) const {
        return reasons_[static_cast<std::size_t>(kind)];
    }
    /// The first one that is there.
    [[nodiscard]] RendererKind best() const {
        RendererKind kind = RendererKind::Fixed;
        while (!has(kind))
            kind = static_cast<RendererKind>(static_cast<std::uint32_t>(kind) + 1);
        return kind;
    }

    bool operator==(const OfferedRenderers&) const = default;

private:
    static_assert(rendererKindRows.back().value == static_cast<std::uint32_t>(RendererKind::Reference),
                  "the search for the best ends there");
    std::array<Sentence, rendererKindRows.size()> reasons_;
};

} // namespace texplorer::view

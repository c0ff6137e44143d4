#include "app/ui/explain/explain_tab.h"
#include "app/ui/model/explaining.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {

using reference::Explanation;
using reference::Ink;
using reference::PixelBytes;
using reference::StepRow;

Comparison compareRenderers(const Session& session, const Pictures& pictures,
                            const Explanation& explanation) {
    Comparison comparison;
    const auto add = [&](RendererKind renderer, const PixelBytes& bytes, reference::StepCell remark) {
        StepRow& row = comparison.rows.emplace_back();
        row.label = rowOf(renderer).label;
        row.swatch = colorOfBytes(bytes);
        row.cells = {{reference::bytesText(bytes), Ink::Plain}, std::move(remark)};
    };
    add(RendererKind::Reference, explanation.bytes, {});
    // While the scene moves the pictures are newer than the answer, so that a comparison is meaningless.
    const bool comparable = explainsThePicture(session);
    for (const ViewFrame& view : pictures.frames) {
        if (!view.image || !view.whole || view.image->width != explanation.width ||
            view.image->height != explanation.height || view.image->format != PixelFormat::Rgba8)
            continue;
        PixelBytes bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] =
                std::to_integer<std::uint8_t>(view.image->at(explanation.pixel.x, explanation.pixel.y)[i]);
        reference::StepCell remark;
        if (comparable) {
            const int most = reference::differenceOf(explanation.bytes, bytes);
            const int tolerance = session.view.tolerance;
            const bool isTie = most > tolerance && reference::isAsRight(explanation, bytes, tolerance);
            comparison.most = std::max(comparison.most, isTie ? 0 : most);
            comparison.compared.emplace_back(rowOf(view.renderer).label);
            remark = most == 0 ? reference::StepCell{N_("the same"), Ink::Dim}
                     : isTie   ? reference::StepCell{Sentence("off by {0}: a tie, either is right", most)}
                               : reference::StepCell{Sentence("off by {0}", most),
                                                   most > tolerance ? Ink::Bad : Ink::Plain};
        }
        add(view.renderer, bytes, std::move(remark));
    }
    return comparison;
}

bool mayDifferByMethod(const Session& session, const Explanation& explanation) {
    const reference::FragmentExplanation* seen = explanation.seen();
    return seen && session.view.anisotropy == reference::AnisotropyMethod::Probes &&
           std::ranges::any_of(seen->units, [](const reference::UnitExplanation& unit) {
               return unit.sampler.maxAnisotropy > 1 && unit.sample.lod.probes > 1;
           });
}

} // namespace texplorer::ui

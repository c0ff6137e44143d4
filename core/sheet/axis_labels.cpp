#include "texplorer/sheet/axis_labels.h"

#include "texplorer/base/translatable.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::sheet {

Sentence labelOf(const ParamRow& row, const std::string& value, LabelKind kind) {
    if (kind == LabelKind::Names)
        return ProperName{value};
    if (const EnumRow* choice = findRow(row.choices, value))
        return choice->label;
    if (row.kind == Kind::Bool)
        return value == "true" ? N_("on") : N_("off");
    return row.range.unit.empty() ? Sentence(ProperName{value})
                                  : Sentence("{0} {1}", ProperName{value}, row.range.unit);
}

std::vector<AxisLabels> labelsOf(const Scene& scene, std::span<const SweepAxis> axes, LabelKind kind) {
    std::vector<AxisLabels> labels;
    for (const SweepAxis& axis : axes) {
        AxisLabels made{axis.path, axis.values};
        if (const Result<ParamAt> at = paramAt(scene, axis.path)) {
            made.title = at->row->label;
            for (std::string& value : made.values)
                value = labelOf(*at->row, value, kind);
        }
        labels.push_back(std::move(made));
    }
    std::vector<std::string> titles;
    for (const AxisLabels& each : labels)
        titles.push_back(each.title);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (std::ranges::count(titles, titles[i]) > 1)
            labels[i].title = fmt::format("{} ({})", titles[i], axes[i].path);
    }
    return labels;
}

} // namespace texplorer::sheet

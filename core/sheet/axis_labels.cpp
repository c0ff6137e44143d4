#include "texplorer/sheet/axis_labels.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::sheet {
namespace {

std::string wordsFor(const ParamRow& row, const std::string& value) {
    if (const EnumRow* choice = findRow(row.choices, value))
        return std::string(choice->label);
    if (row.kind == Kind::Bool)
        return value == "true" ? "on" : "off";
    return row.range.unit.empty() ? value : fmt::format("{} {}", value, row.range.unit);
}

} // namespace

std::vector<AxisLabels> labelsOf(const Scene& scene, std::span<const SweepAxis> axes, LabelKind kind) {
    std::vector<AxisLabels> labels;
    for (const SweepAxis& axis : axes) {
        AxisLabels made{axis.path, axis.values};
        if (const Result<ParamAt> at = paramAt(scene, axis.path)) {
            made.title = at->row->label;
            for (std::string& value : made.values)
                value = kind == LabelKind::Words ? wordsFor(*at->row, value) : value;
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

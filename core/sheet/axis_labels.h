#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/gl/enum_row.h"
#include "texplorer/scene/params/sweep_axis.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::sheet {

/// How values are written.
enum class LabelKind : std::uint8_t { Names, Words };

inline constexpr std::array labelKindRows{
    row(LabelKind::Names, "names", "Names", "OpenGL's names, as --set takes them: GL_NEAREST."),
    row(LabelKind::Words, "words", "Words", "the names in the window's panels: Nearest."),
};

/// The texts next to an axis.
struct AxisLabels {
    std::string title{};               ///< the parameter's label: "Wrap s"
    std::vector<std::string> values{}; ///< in the order of the axis

    bool operator==(const AxisLabels&) const = default;
};

/// The label of a parameter's value.
[[nodiscard]] Sentence labelOf(const ParamRow& row, const std::string& value, LabelKind kind);

/// Returns the labels of axes of a scene. If two parameters have the same label, the titles are their paths.
[[nodiscard]] std::vector<AxisLabels> labelsOf(const Scene& scene, std::span<const SweepAxis> axes,
                                               LabelKind kind);

} // namespace texplorer::sheet

template<>
struct texplorer::EnumTable<texplorer::sheet::LabelKind> {
    static constexpr std::span<const EnumRow> rows = texplorer::sheet::labelKindRows;
};

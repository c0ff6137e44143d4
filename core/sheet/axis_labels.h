#pragma once

#include "core/gl/enum_row.h"
#include "core/scene/params/sweep_axis.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::sheet {

/// What values are called.
enum class LabelKind : std::uint8_t { Names, Words };

inline constexpr std::array labelKindRows{
    row(LabelKind::Names, "names", "Names", "OpenGL's, as --set takes them: GL_NEAREST."),
    row(LabelKind::Words, "words", "Words", "those of the window's panels: Nearest."),
};

/// What is written beside an axis.
struct AxisLabels {
    std::string title{};               ///< the parameter's label: "Wrap s"
    std::vector<std::string> values{}; ///< in the order of the axis

    bool operator==(const AxisLabels&) const = default;
};

/// Of axes that are the scene's own. Where two parameters have the same label, their titles say their paths.
[[nodiscard]] std::vector<AxisLabels> labelsOf(const Scene& scene, std::span<const SweepAxis> axes,
                                               LabelKind kind);

} // namespace texplorer::sheet

template<>
struct texplorer::EnumTable<texplorer::sheet::LabelKind> {
    static constexpr std::span<const EnumRow> rows = texplorer::sheet::labelKindRows;
};

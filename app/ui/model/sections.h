#pragma once

#include <array>
#include <string_view>

namespace texplorer::ui {

/// The parts of the parameters, from top to bottom.
enum class Section { Texture, Unit, Combine, Coordinates, Matrix, Model, Pass, Light, Material, View };

struct SectionRow {
    Section section;
    std::string_view name; ///< for texshot's --section
    const char* title;
    bool open; ///< from the start
};

inline constexpr std::array sectionRows{
    SectionRow{Section::Texture, "texture", "Texture", true},
    SectionRow{Section::Unit, "unit", "Unit and environment", true},
    SectionRow{Section::Combine, "combine", "Combine", true},
    SectionRow{Section::Coordinates, "coordinates", "Generated coordinates", false},
    SectionRow{Section::Matrix, "matrix", "Texture matrix", false},
    SectionRow{Section::Model, "model", "Model", false},
    SectionRow{Section::Pass, "pass", "Pass", false},
    SectionRow{Section::Light, "light", "Light", false},
    SectionRow{Section::Material, "material", "Material", false},
    SectionRow{Section::View, "view", "View", false},
};

[[nodiscard]] constexpr const SectionRow& rowOf(Section section) {
    return sectionRows[static_cast<std::size_t>(section)];
}
static_assert([] {
    for (const SectionRow& row : sectionRows) {
        if (&rowOf(row.section) - sectionRows.data() != &row - sectionRows.data())
            return false;
    }
    return true;
}());

} // namespace texplorer::ui

#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer::ui {

/// The tabs of the parameters.
enum class ParameterTab { Essentials, Texture, Unit, Coordinates, Pass, Light, View };

struct ParameterTabRow {
    ParameterTab tab;
    const char* label;
    const char* help;
};

inline constexpr std::array parameterTabRows{
    ParameterTabRow{ParameterTab::Essentials, "Essentials", "The most important settings, one click each"},
    ParameterTabRow{ParameterTab::Texture, "Texture",
                    "The texture object: its image, filters, wrap modes and levels"},
    ParameterTabRow{ParameterTab::Unit, "Unit", "What the texture unit does with the texture's colour"},
    ParameterTabRow{ParameterTab::Coordinates, "Coordinates",
                    "Texture coordinates: how they are generated and transformed"},
    ParameterTabRow{ParameterTab::Pass, "Pass", "Passes and their tests, blending and fog"},
    ParameterTabRow{ParameterTab::Light, "Light", "The light and the materials"},
    ParameterTabRow{ParameterTab::View, "View", "The models and the camera"},
};

/// The sections of the tabs, from top to bottom.
enum class Section {
    Essentials,
    Texture,
    Unit,
    Combine,
    Coordinates,
    Matrix,
    Pass,
    Light,
    Material,
    Model,
    View
};

struct SectionRow {
    Section section;
    std::string_view name; ///< for texshot's --section
    const char* title;
    ParameterTab tab;
};

inline constexpr std::array sectionRows{
    SectionRow{Section::Essentials, "essentials", "Essentials", ParameterTab::Essentials},
    SectionRow{Section::Texture, "texture", "Texture", ParameterTab::Texture},
    SectionRow{Section::Unit, "unit", "Unit and environment", ParameterTab::Unit},
    SectionRow{Section::Combine, "combine", "Combine", ParameterTab::Unit},
    SectionRow{Section::Coordinates, "coordinates", "Generated coordinates", ParameterTab::Coordinates},
    SectionRow{Section::Matrix, "matrix", "Texture matrix", ParameterTab::Coordinates},
    SectionRow{Section::Pass, "pass", "Pass", ParameterTab::Pass},
    SectionRow{Section::Light, "light", "Light", ParameterTab::Light},
    SectionRow{Section::Material, "material", "Material", ParameterTab::Light},
    SectionRow{Section::Model, "model", "Model", ParameterTab::View},
    SectionRow{Section::View, "view", "Camera", ParameterTab::View},
};

[[nodiscard]] constexpr const ParameterTabRow& rowOf(ParameterTab tab) {
    return parameterTabRows[static_cast<std::size_t>(tab)];
}
[[nodiscard]] constexpr const SectionRow& rowOf(Section section) {
    return sectionRows[static_cast<std::size_t>(section)];
}
static_assert(std::ranges::all_of(sectionRows,
                                  [](const SectionRow& row) { return &rowOf(row.section) == &row; }));
static_assert(std::ranges::all_of(parameterTabRows,
                                  [](const ParameterTabRow& row) { return &rowOf(row.tab) == &row; }));

} // namespace texplorer::ui

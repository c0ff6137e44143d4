#pragma once

#include "texplorer/base/translatable.h"

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
    ParameterTabRow{ParameterTab::Essentials, N_("Essentials"),
                    N_("The most important settings, one click each")},
    ParameterTabRow{ParameterTab::Texture, N_("Texture"),
                    N_("The texture object: its image, filters, wrap modes and levels")},
    ParameterTabRow{ParameterTab::Unit, N_("Unit"),
                    N_("What the texture unit does with the texture's colour")},
    ParameterTabRow{ParameterTab::Coordinates, N_("Coordinates"),
                    N_("Texture coordinates: how they are generated and transformed")},
    ParameterTabRow{ParameterTab::Pass, N_("Pass"), N_("Passes and their tests, blending and fog")},
    ParameterTabRow{ParameterTab::Light, N_("Light"), N_("The light and the materials")},
    ParameterTabRow{ParameterTab::View, N_("View"), N_("The models and the camera")},
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
    SectionRow{Section::Essentials, "essentials", N_("Essentials"), ParameterTab::Essentials},
    SectionRow{Section::Texture, "texture", N_("Texture"), ParameterTab::Texture},
    SectionRow{Section::Unit, "unit", N_("Unit and environment"), ParameterTab::Unit},
    SectionRow{Section::Combine, "combine", N_("Combine"), ParameterTab::Unit},
    SectionRow{Section::Coordinates, "coordinates", N_("Generated coordinates"), ParameterTab::Coordinates},
    SectionRow{Section::Matrix, "matrix", N_("Texture matrix"), ParameterTab::Coordinates},
    SectionRow{Section::Pass, "pass", N_("Pass"), ParameterTab::Pass},
    SectionRow{Section::Light, "light", N_("Light"), ParameterTab::Light},
    SectionRow{Section::Material, "material", N_("Material"), ParameterTab::Light},
    SectionRow{Section::Model, "model", N_("Model"), ParameterTab::View},
    SectionRow{Section::View, "view", N_("Camera"), ParameterTab::View},
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

#include "app/ui/model/explaining.h"
#include "app/ui/model/level_view.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/table_colors.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/image/mean_color.h"
#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/reference/shading/combine.h"
#include "texplorer/reference/shading/equation_text.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <array>

namespace texplorer::ui {
namespace {

using reference::EnvironmentEquations;
using reference::EnvironmentInputs;

/// The inputs and the result of an environment.
struct EnvironmentSample {
    BaseFormat format = BaseFormat::Rgba;
    EnvironmentInputs inputs;
    EnvironmentEquations equations;
    glm::vec4 result{0};
    bool probed = false;
};

/// The units of a pass up to the selected one, with glColor and the mean of each image.
EnvironmentSample referenceSample(const Session& session, const Scene& scene, const Pass& pass) {
    const auto chosen = static_cast<std::size_t>(session.look.selection.unit);
    const auto model = static_cast<std::size_t>(session.look.selection.model);
    const glm::vec4 primary = glm::clamp(
        model < scene.models.size() ? materialOf(scene, scene.models[model]).color : scene.material.color,
        0.0F, 1.0F);
    EnvironmentSample sample;
    std::array<glm::vec4, maxUnits> sources{};
    std::array<const glm::vec4*, maxUnits> textures{};
    std::array<BaseFormat, maxUnits> formats{};
    for (std::size_t u = 0; u < maxUnits; ++u) {
        const Texture* texture = textureOf(scene, pass.units[u]);
        if (!texture || (u != chosen && !pass.units[u].enabled))
            continue;
        const auto summary = summaryOf(session, levelsOf(session, *texture, pass.units[u].target));
        const bool isThere = summary && !summary->levels.empty();
        formats[u] = baseFormatOf(*texture, summary.get());
        sources[u] = reference::sourceColor(formats[u], isThere ? meanColor(*summary->levels.front().second)
                                                                : glm::vec4(1));
        textures[u] = &sources[u];
    }
    glm::vec4 previous = primary;
    for (std::size_t u = 0; u <= chosen; ++u) {
        const Unit& unit = pass.units[u];
        if (u != chosen && !textures[u])
            continue;
        sample.format = formats[u];
        sample.inputs = {previous, sources[u], glm::clamp(unit.envColor, 0.0F, 1.0F), primary};
        const bool combines = unit.envMode == EnvMode::Combine;
        sample.equations = combines ? reference::equationsOf(unit.combine, sample.inputs, textures)
                                    : reference::equationsOf(unit.envMode, sample.format, sample.inputs);
        previous = (combines ? reference::evaluate(unit.combine, sample.inputs, textures)
                             : reference::evaluate(unit.envMode, sample.format, sample.inputs))
                       .color;
    }
    sample.result = previous;
    return sample;
}

EnvironmentSample sampleOf(const Session& session, const Scene& scene, const Pass& pass) {
    const Unit& unit = pass.units[static_cast<std::size_t>(session.look.selection.unit)];
    const reference::UnitExplanation* probed = probedUnit(session);
    if (probed && probed->mode == unit.envMode)
        return {probed->format, probed->inputs, probed->equations, probed->result, true};
    return referenceSample(session, scene, pass);
}

Sentence numbersOf(glm::vec4 color) {
    const auto number = [](float value) { return Sentence(ProperName{reference::shortNumber(value)}); };
    return {N_("({0}, {1}, {2}), alpha {3}"), number(color.r), number(color.g), number(color.b),
            number(color.a)};
}

void equationLine(const reference::Equation& equation, std::string_view name) {
    const std::string line = reference::withHandSigns(tr(equation.symbols));
    ImGui::PushFont(codeFont());
    const bool isCut = fittedText(ProperName{line}, color::text);
    ImGui::PopFont();
    noteItem(fmt::format("environment:{}", name));
    noteItem(fmt::format("environment:{}", line));
    std::string tip = isCut ? line : std::string();
    for (const Sentence& numbers : equation.numbers)
        tip += (tip.empty() ? "" : "\n") + reference::withHandSigns(tr(numbers));
    helpTip(ProperName{tip});
}

/// A colour with its name; its alpha shows as a checker behind the right half.
void swatch(const char* name, glm::vec4 value, bool counts, const char* help) {
    const float extent = ImGui::GetFontSize();
    plainText(name, counts ? color::text : color::dim);
    ImGui::SameLine(0, ImGui::GetFontSize() * 0.25F);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * (counts ? 1.0F : 0.35F));
    ImGui::ColorButton(name, {value.r, value.g, value.b, value.a},
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_AlphaPreviewHalf |
                           ImGuiColorEditFlags_NoDragDrop,
                       {extent * 1.6F, extent});
    ImGui::PopStyleVar();
    item(fmt::format("environment:{}", name), Sentence("{0}\n{1}", help, numbersOf(value)));
}

bool hasSymbol(const EnvironmentEquations& equations, const char* color, const char* alpha) {
    const auto has = [&](const reference::Equation& equation, const char* symbol) {
        return equation.symbols.find(symbol) != std::string::npos;
    };
    return has(equations.color, color) || has(equations.color, alpha) || has(equations.alpha, color) ||
           has(equations.alpha, alpha);
}

} // namespace

void environmentLine(const Session& session) {
    const Scene& shown = shownScene(session);
    const Scene& scene = &shown == &session.document.scene ? presentScene(session) : shown;
    const auto number = static_cast<std::size_t>(session.look.selection.pass);
    if (number >= scene.passes.size())
        return;
    const EnvironmentSample sample = sampleOf(session, scene, scene.passes[number]);
    ImGui::PushID("environment");
    ImGui::BeginGroup();
    equationLine(sample.equations.color, "color");
    equationLine(sample.equations.alpha, "alpha");
    ImGui::EndGroup();
    const float gap = ImGui::GetFontSize() * 0.6F;
    struct Input {
        const char* name;
        const char* alpha;
        glm::vec4 color;
        const char* help;
    };
    const std::array inputs{
        Input{N_("Cp"), N_("Ap"), sample.inputs.previous,
              session.look.selection.unit == 0 ? N_("Cp: the fragment's colour from lighting or glColor")
                                               : N_("Cp: the result of the units before this one")},
        Input{N_("Cs"), N_("As"), sample.inputs.source,
              sample.probed ? N_("Cs: the texture's colour at the explained pixel")
                            : N_("Cs: the texture's colour, here the mean of its image")},
        Input{N_("Cc"), N_("Ac"), sample.inputs.constant, N_("Cc: the environment colour")}};
    for (const auto& [name, alpha, color, help] : inputs) {
        swatch(name, color, hasSymbol(sample.equations, name, alpha), help);
        ImGui::SameLine(0, gap);
    }
    dimText("→");
    ImGui::SameLine(0, gap);
    swatch(N_("Cv"), sample.result, true,
           sample.probed
               ? N_("Cv: the result of this unit at the explained pixel")
               : N_("Cv: the result of this unit for glColor and the image's mean. Explain a pixel to "
                    "use that pixel."));
    if (sample.probed)
        noteItem("environment:probed");
    ImGui::PopID();
}

} // namespace texplorer::ui

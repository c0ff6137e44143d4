#include "app/ui/levels/levels_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/level_edits.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/image/cube_faces.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace texplorer::ui {
namespace {

constexpr Range biasRange{-16, 16, 0.05F, {}};

/// The queried pixel in words, or how to select one.
void pixelLine(const Session& session, float room) {
    const reference::LevelMap* map = levelMapOf(session);
    const reference::PixelLevels* levels = askedLevels(session);
    const Sentence words = !map                  ? N_("No pixel reads a level")
                           : levels              ? reference::levelsText(*map, *levels)
                           : askedPixel(session) ? N_("This pixel reads no level")
                                                 : N_("Point at a pixel of the view");
    const std::string shown = fitted(words, room);
    ImGui::AlignTextToFramePadding();
    plainText(shown, levels ? color::probed : color::dim);
    noteItem(levels ? "levels:pixel" : "levels:hint");
    if (levels)
        helpTip(Sentence("{0}\n{1}", words, reference::footprintText(*levels)));
    else if (shown != tr(words))
        helpTip(words);
}

/// Why the texture is incomplete; nullptr: it isn't.
const Finding* incompleteness(const Session& session, const std::string& texture) {
    const auto found = std::ranges::find_if(session.document.findings, [&](const Finding& finding) {
        return finding.rule == "incomplete" && finding.path.starts_with(texture);
    });
    return found == session.document.findings.end() ? nullptr : &*found;
}

/// Why fewer levels are read than expected; empty: no remark.
Sentence remark(const Session& session, const Texture& texture, const Unit& unit,
                const LevelsSummary& summary) {
    if (!unit.enabled)
        return Sentence("Unit {0} is off: its texture is not read.", session.look.selection.unit);
    const std::vector<LevelReport>& levels = summary.report.levels;
    if (texture.baseLevel == texture.maxLevel && levels.size() > 1)
        return Sentence("Only level {0} is read, for any λ.", texture.baseLevel);
    if (levels.size() == 1)
        return N_("There is only the base level: minified pixels have no smaller level to read.");
    if (!reference::wantsMipmaps(texture.minFilter))
        return Sentence("The minification filter {0} reads only the base level, for any λ.",
                        ProperName{rowOf(texture.minFilter).name});
    return {};
}

void fixButtons(const Session& session, const Finding& finding) {
    for (const Fix& fix : finding.fixes) {
        if (&fix != &finding.fixes.front())
            sameLineFor(buttonWidth(fix.label), ImGui::GetStyle().ItemSpacing.x);
        if (smallButton(label(fix.label).c_str()))
            applyFix(session, fix);
        item("levels:fix " + fix.label.english(), assignmentsOf(fix));
    }
}

/// The choice of a cube map's face.
void faceChoice(LevelsTabState& state) {
    std::vector<Segment> faces;
    for (int face = 0; face < cubeFaceCount; ++face)
        faces.push_back({rowOf(cubeFaceAt(face)).label});
    const auto pressed = drawSegments(faces, ImGui::GetContentRegionAvail().x,
                                      static_cast<std::size_t>(state.face), [](std::size_t i) {
                                          const EnumRow& row = rowOf(cubeFaceAt(static_cast<int>(i)));
                                          item(fmt::format("levels:face {}", row.label),
                                               Sentence("{0}\n{1}", ProperName{row.name}, row.help));
                                      });
    if (pressed)
        state.face = static_cast<int>(*pressed);
}

/// The biases of the texture and of the unit, which are added, and a button that removes all limits.
void biasLine(const Session& session, const Texture& texture, const Unit& unit) {
    const float field = ImGui::CalcTextSize("-16.00").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float button = buttonWidth("All levels");
    const float words = ImGui::CalcTextSize(tr("Bias")).x + ImGui::CalcTextSize(tr("texture")).x +
                        ImGui::CalcTextSize(tr("+ unit")).x;
    const bool isBrief = words + 2 * field + 4 * gap + ImGui::GetStyle().ItemSpacing.x + button >
                         ImGui::GetContentRegionAvail().x;
    const auto number = [&](const char* shown, const char* name, float value, const char* help,
                            void (*set)(const Session&, float)) {
        ImGui::SameLine(0, gap);
        dimText(shown);
        ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(field);
        if (dragNumber(fmt::format("##{}", name).c_str(), value, biasRange, -1))
            set(session, value);
        item(name, help);
        sealAfterItem(session);
    };
    labelText("Bias", color::dim);
    number(isBrief ? "" : "texture", "levels:texture bias", texture.lodBias,
           "GL_TEXTURE_LOD_BIAS of the texture, added to λ. Below 0, larger and sharper levels are read.",
           setTextureBias);
    number(isBrief ? "+" : "+ unit", "levels:unit bias", unit.lodBias,
           "GL_TEXTURE_LOD_BIAS of the unit, also added to λ", setUnitBias);
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < button)
        ImGui::NewLine();
    else
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - button);
    const bool limited = limitsLevels(session);
    ImGui::BeginDisabled(!limited);
    if (ImGui::Button(label("All levels")))
        readAllLevels(session);
    ImGui::EndDisabled();
    item("levels:all",
         limited ? N_("Resets base and max level, the limits of λ and both biases to OpenGL's initial "
                      "values")
                 : N_("All levels may be read: base and max level, the limits of λ and both biases have "
                      "OpenGL's initial values."));
}

void drawSummary(const Session& session, LevelsTabState& state, const Pictures& pictures,
                 const LevelsSummary& summary) {
    const Texture& texture = *boundTexture(session);
    const Unit& unit = selectedUnit(session);
    const char* equal = "=";
    const float button = buttonWidth(equal);
    const float left = ImGui::GetCursorPosX();
    pixelLine(session, ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(left, ImGui::GetWindowContentRegionMax().x - button));
    if (markedButton(equal, state.equal))
        state.equal = !state.equal;
    item("levels:equal",
         "Equal sizes: shows all levels at the same size instead of their own sizes. The wheel enlarges "
         "them.");
    const std::string path = elementOf<&Scene::textures>(static_cast<std::size_t>(unit.texture)) + ".";
    if (const Finding* incomplete = incompleteness(session, path)) {
        wrappedText(shownSentence(incomplete->sentence), color::problem);
        noteItem("levels:incomplete");
        fixButtons(session, *incomplete);
    } else if (const Sentence words = remark(session, texture, unit, summary); !words.empty()) {
        wrappedText(words, color::dim);
        noteItem("levels:remark");
    }
    if (unit.target == Target::CubeMap)
        faceChoice(state);
    drawLevelStrip(session, state, pictures, summary,
                   ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y);
    biasLine(session, texture, unit);
}

} // namespace

void drawLevelsTab(const Session& session, LevelsTabState& state, const Pictures& pictures) {
    const std::optional<LevelsRequest> request = requestLevels(session);
    if (!request)
        return;
    const std::shared_ptr<const LevelsSummary> summary = summaryOf(session, *request);
    if (!summary) {
        dimText("The levels are being made…");
        noteItem("levels:waiting");
    } else if (!summary->problem.empty() || summary->report.levels.empty()) {
        wrappedText(summary->problem.empty() ? "There is no level." : summary->problem, color::problem);
        noteItem("levels:problem");
    } else {
        drawSummary(session, state, pictures, *summary);
    }
}

} // namespace texplorer::ui

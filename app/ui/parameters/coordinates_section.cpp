// The coordinates that OpenGL generates (glTexGen): one line for each of s, t, r and q, and the plane that
// its mode reads while it is on.

#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/param_widgets.h"
#include "texplorer/scene/light_projection.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <array>

namespace texplorer::ui {
namespace {

struct Coordinate {
    const char* letter;
    Key key; ///< of the unit
    TexGen Unit::*state;
};

constexpr std::array<Coordinate, 4> coordinates{{{"s", keyOf<&Unit::texGenS>, &Unit::texGenS},
                                                 {"t", keyOf<&Unit::texGenT>, &Unit::texGenT},
                                                 {"r", keyOf<&Unit::texGenR>, &Unit::texGenR},
                                                 {"q", keyOf<&Unit::texGenQ>, &Unit::texGenQ}}};

/// Buttons that set several of these parameters and others at once.
void lightButtons(const Session& session) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    const Selection& selection = session.look.selection;
    const auto button = [&](const char* words, const char* tip, auto&& edit) {
        if (ImGui::Button(label(words), {width, 0})) {
            bool hasRoom = false;
            submit(session, words, [&](Scene& scene) { hasRoom = edit(scene); });
            if (!hasRoom)
                act(session, [](Session& told) {
                    say(told, "Not possible: no more textures or matrix steps can be added.");
                });
        }
        noteItem(words);
        helpTip(tip);
    };
    button("Slide projector",
           "Makes the light a slide projector: generates s, t, r and q in eye coordinates and adds the "
           "projector to the texture matrix.",
           [&](Scene& scene) { return projectFromLight(selectedUnit(scene, selection)); });
    ImGui::SameLine(0, gap);
    button("Shadow map",
           "Multiplies by the light's shadows: adds a depth texture of the light's view, which r is "
           "compared with.",
           [&](Scene& scene) {
               return castShadows(scene, static_cast<std::size_t>(selection.pass),
                                  static_cast<std::size_t>(selection.unit));
           });
}

} // namespace

void coordinatesSection(const Session& session) {
    const Unit& unit = selectedUnit(session);
    static const Unit initial;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Coordinate& coordinate = coordinates[i];
        const TexGen& state = unit.*coordinate.state;
        const Owner owner{&(unit.*coordinate.state), &(initial.*coordinate.state),
                          fmt::format("{}.{}", selectedUnitPath(session), coordinate.key())};
        const StructTable& table = texGenTable(i);
        ImGui::AlignTextToFramePadding();
        plainText(coordinate.letter, componentColor(static_cast<int>(i)));
        ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 1.2F);
        paramControl(session, owner, *findParam(table, keyOf<&TexGen::enabled>()), 0);
        ImGui::SameLine(0, gap);
        paramControl(session, owner, *findParam(table, keyOf<&TexGen::mode>()),
                     ImGui::GetContentRegionAvail().x);
        RowOptions planes; // at most one of which is read
        planes.leavesOut = [](const ParamRow& row) {
            return row.member == memberId<&TexGen::enabled> || row.member == memberId<&TexGen::mode>;
        };
        planes.folds = [&](const ParamRow& row) {
            return !state.enabled || idleReasonOf(session.document.findings, owner.pathOf(row)) != nullptr;
        };
        paramRows(session, owner, table, planes);
    }
    lightButtons(session);
    const Owner emboss{&unit.emboss, &initial.emboss,
                       fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::emboss>())};
    caption("Emboss");
    RowOptions options;
    options.folds = [&](const ParamRow& row) {
        return !unit.emboss.enabled && row.member != memberId<&Emboss::enabled>;
    };
    paramRows(session, emboss, embossTable(), options);
}

} // namespace texplorer::ui

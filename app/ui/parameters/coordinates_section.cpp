// The coordinates that OpenGL generates (glTexGen): one line for each of s, t, r and q, and the plane that
// its mode reads while it is on.

#include "app/ui/model/notice.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "texplorer/scene/light_projection.h"
#include "texplorer/scene/params/keys.h"

#include <array>

namespace texplorer::ui {
namespace {

constexpr std::array coordinateLetters{"s", "t", "r", "q"};

/// Buttons that set several of these parameters and others at once.
void lightButtons(const Session& session) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    const Selection& selection = session.look.selection;
    const auto offer = [&](const char* words, const char* tip, auto&& edit) {
        if (!button(words, words, tip, true, width))
            return;
        bool hasRoom = false;
        submit(session, words, [&](Scene& scene) { hasRoom = edit(scene); });
        if (!hasRoom)
            act(session, [](Session& told) {
                say(told, N_("Not possible: no more textures or matrix steps can be added."));
            });
    };
    offer(N_("Slide projector"),
          N_("Makes the light a slide projector: generates s, t, r and q in eye coordinates and adds the "
             "projector to the texture matrix."),
          [&](Scene& scene) { return projectFromLight(selectedUnit(scene, selection)); });
    ImGui::SameLine(0, gap);
    offer(N_("Shadow map"),
          N_("Multiplies by the light's shadows: adds a depth texture of the light's view, which r is "
             "compared with."),
          [&](Scene& scene) {
              return castShadows(scene, static_cast<std::size_t>(selection.pass),
                                 static_cast<std::size_t>(selection.unit));
          });
}

} // namespace

void coordinatesSection(const Session& session) {
    const std::vector<ShownStruct> places = shownStructs(session, Section::Coordinates);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    for (std::size_t i = 0; i < coordinateLetters.size(); ++i) {
        const Owner& owner = places[i].owner;
        const StructTable& table = *places[i].table;
        const auto& state = *static_cast<const TexGen*>(owner.values);
        ImGui::AlignTextToFramePadding();
        plainText(coordinateLetters[i], componentColor(static_cast<int>(i)));
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
    const ShownStruct& emboss = places.back();
    caption(emboss.title);
    RowOptions options;
    options.folds = [&](const ParamRow& row) {
        return !selectedUnit(session).emboss.enabled && row.member != memberId<&Emboss::enabled>;
    };
    paramRows(session, emboss.owner, *emboss.table, options);
}

} // namespace texplorer::ui

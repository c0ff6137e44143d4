#include "app/ui/figures/plot.h"
#include "app/ui/figures/sheet.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/files/texshot_command.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/param_match.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/text_field.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr std::array<const char*, 2> sideNames{N_("Rows"), N_("Columns")};

/// The label of the parameter at a path; the path if there is none.
Sentence labelAt(const Session& session, const std::string& path) {
    const Result<ParamAt> at = paramAt(presentScene(session), path);
    return at ? Sentence(shownName(session.settings, *at->row)) : ProperName{path};
}

void findOffers(const Session& session, SheetState& state) {
    state.offers.clear();
    const Texture* bound = boundTexture(session);
    const std::string texture = bound ? elementOf<&Scene::textures>(static_cast<std::size_t>(
                                            bound - presentScene(session).textures.data())) +
                                            "."
                                      : std::string();
    const std::string unit = selectedUnitPath(session) + ".";
    // Parameters of the selection come first.
    std::vector<std::pair<int, SheetState::Offer>> found;
    forEachParam(presentScene(session), [&](const std::string& path, const ParamRow& row, const Value&) {
        const int match = state.search.empty() ? 1 : matchOf(row, state.search);
        if (!canSweep(row) || match == 0)
            return;
        const bool selected = (bound && path.starts_with(texture)) || path.starts_with(unit);
        found.emplace_back((match == 2 ? 0 : 2) + (selected ? 0 : 1),
                           SheetState::Offer{path, std::string(shownName(session.settings, row))});
    });
    std::ranges::stable_sort(found, {}, &std::pair<int, SheetState::Offer>::first);
    for (auto& [rank, offer] : found)
        state.offers.push_back(std::move(offer));
    state.isOffered = true;
}

/// The list of parameters with a search field. Returns the chosen path.
std::optional<std::string> choosePath(const Session& session, SheetState& state, const std::string& current) {
    const float em = ImGui::GetFontSize();
    if (ImGui::IsWindowAppearing()) {
        state.search.clear();
        state.isOffered = false;
        focusNextWidget();
    }
    const float width = em * 28;
    ImGui::SetNextItemWidth(width);
    if (textField("##search", state.search, ImGuiInputTextFlags_AutoSelectAll, tr("Search")))
        state.isOffered = false;
    noteItem("sheet:search");
    if (!state.isOffered)
        findOffers(session, state);
    std::optional<std::string> chosen;
    ImGui::BeginChild("offers", {width, em * 16});
    if (state.offers.empty())
        wrappedText("No choice, number or colour has this name.");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(state.offers.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const SheetState::Offer& offer = state.offers[static_cast<std::size_t>(i)];
            if (ImGui::Selectable(fmt::format("{}##{}", tr(offer.label), offer.path).c_str(),
                                  offer.path == current))
                chosen = offer.path;
            noteItem("sheet offer:" + offer.path);
            ImGui::SameLine(em * 11);
            dimPlainText(offer.path);
        }
    }
    ImGui::EndChild();
    if (chosen)
        ImGui::CloseCurrentPopup();
    return chosen;
}

constexpr const char* saveWords = N_("Save…");
constexpr const char* copyWords = N_("Copy command");

/// The options of the file: the extent of each picture, and the names of values.
void fileOptions(const Session& session) {
    const float em = ImGui::GetFontSize();
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const SheetChoice& choice = session.sheet;
    const auto number = [&](const char* name, int SheetChoice::*member) {
        int value = choice.*member;
        ImGui::SetNextItemWidth(em * 4.5F);
        if (dragInt(name, value, 1, 1, reference::maxPictureExtent))
            act(session, [member, value](Session& changed) { changed.sheet.*member = value; });
        markDraggable();
        item(fmt::format("sheet file:{}", name + 2),
             "The size of each picture in pixels. Drag it, or double-click to type a number.");
    };
    const float names = em * 7;
    rowName(N_("Each picture"), names);
    number("##width", &SheetChoice::width);
    ImGui::SameLine(0, inner);
    ImGui::TextUnformatted("×");
    ImGui::SameLine(0, inner);
    number("##height", &SheetChoice::height);
    rowName(N_("Values"), names);
    for (const EnumRow& row : EnumTable<sheet::LabelKind>::rows) {
        if (&row != &EnumTable<sheet::LabelKind>::rows.front())
            ImGui::SameLine(0, em * 0.8F);
        if (ImGui::RadioButton(label(row.label).c_str(),
                               row.value == static_cast<std::uint32_t>(choice.labels)))
            act(session, [&row](Session& changed) {
                changed.sheet.labels = static_cast<sheet::LabelKind>(row.value);
            });
        item(fmt::format("sheet file:{}", row.name), row.help);
    }
}

/// Buttons for the sheet as a file and as a command.
void fileControls(const Session& session) {
    if (ImGui::Button(label(saveWords)))
        ImGui::OpenPopup("file");
    item("sheet:save",
         "Writes the sheet with every value as a PNG file, with labels and the reference's pictures.");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button(label(copyWords))) {
        if (const Result<std::string> command = sweepCommand(session); command) {
            ImGui::SetClipboardText(command->c_str());
            act(session, [](Session& told) {
                tell(told, "Copied a command that draws this sheet without a window.");
            });
        } else {
            act(session, [why = describe(command.error())](Session& told) {
                say(told, Sentence("No command can draw this sheet: {0}.", why));
            });
        }
    }
    item("sheet:copy",
         "Copies a \"texshot sweep\" command that writes the same file without a window, for scripts.");
    if (!beginPopup("file"))
        return;
    fileOptions(session);
    ImGui::Separator();
    const Result<glm::ivec2> extent = sheetExtent(session);
    if (extent)
        dimText(Sentence("The sheet has {0} × {1} pixels.", extent->x, extent->y));
    else
        sheetProblem(describe(extent.error()));
    ImGui::BeginDisabled(!extent);
    if (ImGui::Button(label("Choose a file…"))) {
        act(session, [](Session& changed) { changed.asking.dialog = Dialog::SaveSheet; });
        ImGui::CloseCurrentPopup();
    }
    noteItem("sheet file:choose");
    ImGui::EndDisabled();
    endPopup();
}

/// A button with a parameter's name, and the field of its values, both of this width.
void axisControls(const Session& session, SheetState& state, const SheetAxes& shown, std::size_t side,
                  float width) {
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const SheetAxis& axis = shown.at(side);
    const auto choose = [&](SheetAxis chosen) {
        act(session, [shown, side, picked = std::move(chosen)](Session& changed) {
            std::optional<SheetAxes>& axes = changed.sheet.own;
            if (!axes)
                axes = shown;
            axes->at(side) = picked;
        });
    };
    ImGui::PushID(sideNames.at(side));
    const std::string name = fitted(labelAt(session, axis.path), width - ImGui::GetFontSize() * 0.6F);
    if (ImGui::Button(fmt::format("{}###path", name).c_str(), {width, 0}))
        ImGui::OpenPopup("paths");
    item(fmt::format("sheet:{}", sideNames.at(side)),
         Sentence("{0}\n{1}", ProperName{axis.path}, N_("Select another parameter.")));
    if (beginPopup("paths")) {
        if (std::optional<std::string> path = choosePath(session, state, axis.path))
            choose({*std::move(path), "*"});
        endPopup();
    }
    ImGui::SameLine(0, inner);
    ImGui::SetNextItemWidth(width);
    if (state.typedOf.at(side) != axis) {
        state.typedOf.at(side) = axis;
        state.typed.at(side) = axis.values;
    }
    (void)textField("##values", state.typed.at(side), ImGuiInputTextFlags_AutoSelectAll, "*");
    const bool ended = ImGui::IsItemDeactivatedAfterEdit();
    item(fmt::format("sheet values:{}", sideNames.at(side)),
         "The values: 1,2,4 or 0..4/5 (five numbers from 0 to 4). * means all values, or a few of a "
         "number. Separate colours with semicolons.");
    if (ended && state.typed.at(side) != axis.values)
        choose({axis.path, state.typed.at(side).empty() ? "*" : state.typed.at(side)});
    ImGui::PopID();
}

void pairChoice(const Session& session, float width) {
    const SheetChoice& choice = session.sheet;
    const char* current = choice.own ? N_("Your own pair") : sheetPairs().at(choice.pair).label;
    ImGui::SetNextItemWidth(width);
    const std::string name = fitted(current, listRoom(width));
    const bool open = beginCombo("##pair", name.c_str(), ImGuiComboFlags_HeightLargest);
    item("sheet:pair",
         "Useful pairs of parameters. Or select any two next to it, or in the panel with a right click.");
    if (!open)
        return;
    for (std::size_t i = 0; i < sheetPairs().size(); ++i) {
        const SheetPair& pair = sheetPairs().at(i);
        if (ImGui::Selectable(label(pair.label), !choice.own && choice.pair == i))
            act(session, [i](Session& changed) {
                changed.sheet.own.reset();
                changed.sheet.pair = i;
            });
        item(fmt::format("sheet pair:{}", pair.name), pair.help);
    }
    endCombo();
}

} // namespace

void sheetProblem(const Sentence& words) {
    wrappedText(words, color::problem);
    noteItem("sheet:problem");
}

void drawSheetControls(const Session& session, SheetState& state, const SheetAxes& shown,
                       const std::function<void()>& sentence) {
    const float em = ImGui::GetFontSize();
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float gap = em * 0.8F;
    const float names = ImGui::CalcTextSize(tr(sideNames[0])).x + ImGui::CalcTextSize(tr(sideNames[1])).x;
    const float room = ImGui::GetContentRegionAvail().x;
    // Everything in one line if there is room, or both parameters in one.
    const float spare = room - names - buttonWidth("Swap") - buttonWidth(saveWords) - buttonWidth(copyWords) -
                        5 * gap - 6 * inner;
    const bool inLine = spare > em * 38;
    const float both = room - names - gap - 4 * inner;
    const bool inTwo = !inLine && both > em * 20;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, std::max(1.0F, std::floor(em / 8))});
    pairChoice(session, std::floor(inLine ? spare * 0.23F : std::min(room * 0.5F, em * 14)));
    ImGui::SameLine(0, gap);
    if (ImGui::Button(label("Swap")))
        act(session, [](Session& changed) {
            SheetChoice& choice = changed.sheet;
            if (choice.own)
                std::swap((*choice.own)[0], (*choice.own)[1]);
            else
                choice.swapped = !choice.swapped;
        });
    item("sheet:swap", "Swaps rows and columns.");
    ImGui::SameLine(0, inner);
    fileControls(session);
    if (inTwo) {
        ImGui::SameLine(0, gap);
        ImGui::AlignTextToFramePadding();
        sentence();
    }
    for (std::size_t side = 0; side < shown.size(); ++side) {
        if (inLine || (inTwo && side > 0))
            ImGui::SameLine(0, gap);
        rowName(sideNames.at(side), 0, inner);
        const float width = inLine  ? spare * 0.385F
                            : inTwo ? both / 2
                                    : ImGui::GetContentRegionAvail().x - inner;
        axisControls(session, state, shown, side, std::floor(width * 0.5F));
    }
    if (!inTwo)
        sentence();
    ImGui::PopStyleVar();
}

} // namespace texplorer::ui

#include "app/ui/figures/upload_figure.h"

#include "app/ui/figures/plot.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/same_line.h"
#include "texplorer/scene/params/keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

/// The base alone, as the call reads it.
LevelsRequest requestOf(const Session& session, const Upload& upload) {
    Texture texture = *boundTexture(session);
    texture.upload = upload;
    texture.mipmaps = MipPolicy::None;
    texture.levels.clear();
    if (!isDepth(texture.internalFormat))
        texture.internalFormat = InternalFormat::Rgba; // with all bits
    if (texture.compression == Compression::Driver)
        texture.compression = Compression::None;
    return levelsOf(session, texture, selectedUnit(session).target);
}

bool follow(Session& session, UploadFigureState& state) {
    const std::pair before(state.held.problem, state.held.levels);
    std::optional<LevelsRequest> bound = boundLevels(session);
    if (bound && state.asked != bound)
        state.facts = uploadFacts(session);
    state.asked = bound;
    const Texture* texture = boundTexture(session);
    if (texture && texture->compression == Compression::Cached) {
        giveLevelsBack(workers(session).levels, state.held);
        state.held.problem = N_("Cached blocks are uploaded as they are: no call reads pixels.");
    } else {
        if (bound)
            bound = requestOf(session, texture->upload.custom ? texture->upload : state.facts.fitting);
        (void)followLevels(workers(session).levels, state.held, std::move(bound));
        if (state.held.problem.empty() && !(*state.held.levels)->call)
            state.held.problem =
                isDrawn(texture->source)
                    ? N_("The driver draws it: no call reads pixels.")
                    : N_("The file's blocks are uploaded as they are: no call reads pixels.");
    }
    return before != std::pair(state.held.problem, state.held.levels);
}

/// The parameters of the call that are most often wrong.
void drawUploadControls(const Session& session) {
    const float em = ImGui::GetFontSize();
    const Owner owner = uploadOwner(session);
    if (!boundTexture(session)->upload.custom) {
        ImGui::AlignTextToFramePadding();
        text(N_("Custom upload is off: this is the call that fits."));
        sameLineFor(buttonWidth(N_("Make it custom")), em);
        if (button(N_("Make it custom"), "upload:custom",
                   N_("Sets the format, type and alignment that fit, to be changed from there")))
            turnUploadOn(session);
        return;
    }
    constexpr std::array<Key, 3> keys{keyOf<&Upload::format>, keyOf<&Upload::alignment>,
                                      keyOf<&Upload::rowLength>};
    const std::array widths{em * 9, em * 5, em * 6};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const ParamRow& row = *findParam(uploadTable(), keys.at(i)());
        if (i > 0)
            sameLineFor(textWidth(row.label) + widths.at(i) + em, em);
        rowName(row.label.data());
        paramControl(session, owner, row, widths.at(i));
    }
}

} // namespace

void drawUploadFigure(const Session& session, UploadFigureState& state) {
    ask(session, [&state](Session& changed) { return follow(changed, state); });
    if (!boundTexture(session))
        return dimWrappedText(N_("Bind a texture to this unit to see its bytes."));
    drawUploadControls(session);
    if (!state.held.levels || !state.held.problem.empty()) {
        dimWrappedText(state.held.problem);
        noteItem("upload:problem");
        return;
    }
    const TextureLevels& levels = **state.held.levels;
    const auto* read = std::get_if<Image>(&*levels.levels.front().surface);
    const Bytes* memory = levels.levels.front().memory.get();
    if (!read || !memory)
        return;
    const UploadLook look{{state.facts.held, *levels.call, {read->width, read->height * read->depth}},
                          memory,
                          read,
                          levels.lateFlip != LateFlip::None};
    const bool fits = look.bytes.heldStride() == look.bytes.readStride() &&
                      look.bytes.held.pixels == look.bytes.call.layout &&
                      bytesRead(look.bytes.call, look.bytes.extent) <= look.bytes.heldBytes();
    const Sentence verdict = verdictOn(look.bytes);
    if (sameLineFor(textWidth(verdict), ImGui::GetFontSize() * 1.5F))
        ImGui::AlignTextToFramePadding();
    fittedText(verdict, fits ? color::text : color::problem);
    noteItem("upload:verdict");
    const UploadMark& mark = state.hovered;
    fittedText(
        mark.texel ? wordsOf(look.bytes, *mark.texel)
        : mark.byte
            ? wordsOf(look.bytes, *mark.byte)
            : Sentence(
                  "The rows of the memory; brackets: what OpenGL reads. Point at a byte or a texel; click "
                  "a texel to find its bytes."),
        mark.texel || mark.byte ? color::text : color::dim);
    noteItem("upload:words");
    state.hovering = {};
    const float em = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x > em * 36;
    const float gap = em;
    const float high = std::max(room.y, em * 9);
    const float side =
        beside ? std::max(std::min(high, room.x * 0.36F), em * 11.5F) : std::min(room.x, em * 16);
    const ImVec2 memorySize(beside ? room.x - side - gap : room.x, beside ? high : em * 12);
    drawUploadMemory(state, look, memorySize);
    if (beside)
        ImGui::SameLine(0, gap);
    drawUploadTexels(state, look, {side, beside ? high : side});
    state.hovered = state.hovering;
}

} // namespace texplorer::ui

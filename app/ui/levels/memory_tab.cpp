// The tab "Memory": the memory of the bound texture, level by level, and the loss by its compression.

#include "app/ui/levels/memory_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/levels/levels_tab.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/param_widgets.h"
#include "texplorer/base/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

/// Sentences about the bound texture: the renderer's, and those about levels that were not drawn yet.
std::vector<Sentence> sentencesOf(const Session& session, const Pictures& pictures,
                                  const LevelsSummary* summary) {
    const std::string where = fmt::format("textures[{}]", selectedUnit(session).texture);
    std::vector<Sentence> sentences;
    const auto add = [&](const Sentence& sentence) {
        if (std::ranges::find(sentences, sentence) == sentences.end())
            sentences.push_back(sentence);
    };
    for (const Sentence& problem : pictures.problems) {
        if (problem.key() == describedKey.text && problem.arguments()[0] == where)
            add(problem.arguments()[1]);
    }
    if (summary) {
        for (const Sentence& note : summary->notes)
            add(note);
    }
    return sentences;
}

void drawSentences(const std::vector<Sentence>& sentences) {
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        wrappedText(shownSentence(sentences[i]), color::problem);
        noteItem(fmt::format("memory:note {}", i));
    }
}

/// The memory of the levels, their number and format.
Sentence sumText(const Texture& texture, const LevelsSummary& summary) {
    const TextureReport& report = summary.report;
    const std::string bytes = grouped(report.bytes);
    const Sentence levels = Sentence::plural("{0} level", "{0} levels", report.levels.size());
    const std::string_view format =
        summary.compressed ? rowOf(*summary.compressed).label : rowOf(texture.internalFormat).label;
    return summary.compressed && summary.byDriver
               ? Sentence("{0} bytes in {1}, {2}, by the driver", ProperName{bytes}, levels, format)
               : Sentence("{0} bytes in {1}, {2}", ProperName{bytes}, levels, format);
}

/// Short facts next to each other; what does not fit begins the next line.
class FactLine {
public:
    void add(const Sentence& words, const char* name, const char* help) {
        const float gap = ImGui::GetFontSize();
        const float width = ImGui::CalcTextSize(tr(words).c_str()).x;
        if (used_ > 0 && used_ + gap + width <= ImGui::GetContentRegionMax().x)
            ImGui::SameLine(0, gap);
        else
            used_ = 0;
        used_ += gap + width;
        dimText(words);
        item(name, help);
    }

private:
    float used_ = 0;
};

/// The sum, compared with the base level and with an uncompressed texture.
void drawSum(const Texture& texture, const LevelsSummary& summary) {
    const TextureReport& report = summary.report;
    ImGui::PushTextWrapPos(0);
    text(sumText(texture, summary));
    ImGui::PopTextWrapPos();
    noteItem("memory:sum");
    FactLine line;
    line.add(Sentence("{0:.3f} × base", report.ratioToBase), "memory:ratio",
             N_("Each level of an image has a quarter of the texels of the level before, so a full chain has "
                "about 4/3 of its base level."));
    line.add(Sentence("{0:.1f} % of RGBA8", 100 * report.shareOfRgba8), "memory:rgba8",
             N_("The share of the memory of the same levels with four bytes a texel"));
    line.add(Sentence("{0:.1f} % of RGB8", 100 * report.shareOfRgb8), "memory:rgb8",
             N_("The share of the memory of the same levels with three bytes a texel"));
}

/// What OpenGL says of the base level and of the object.
void drawStored(const view::StoredTexture& stored, Target target) {
    const view::StoredLevel& base = stored.levels.front();
    ImGui::PushTextWrapPos(0);
    text(Sentence("The driver stores {0}", storedLevelText(base)));
    ImGui::PopTextWrapPos();
    item("memory:stored",
         N_("glGetTexLevelParameteriv of the largest level: its internal format, and the bits "
            "of red, green, blue, alpha, luminance, intensity and depth. A driver may store "
            "more bits than it was asked for."));
    FactLine line;
    const std::string sides = target == Target::Texture1D   ? std::to_string(stored.largest)
                              : target == Target::Texture3D ? fmt::format("{0} × {0} × {0}", stored.largest)
                                                            : fmt::format("{0} × {0}", stored.largest);
    line.add(
        Sentence("up to {0} fit", ProperName{sides}), "memory:largest",
        N_("The largest power of two for which a proxy texture of this format (GL_PROXY_TEXTURE_2D) has a "
           "width: OpenGL says so without making the texture."));
    line.add(
        stored.resident ? N_("resident") : N_("not resident"), "memory:resident",
        N_("GL_TEXTURE_RESIDENT: whether the texture is in the memory that drawing reads. Today's drivers "
           "move textures when they are used; most always say yes and ignore GL_TEXTURE_PRIORITY."));
}

/// The next item, with this text, is at the right edge of its column.
void alignRight(const char* words) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room));
}

void rightAligned(const std::string& text, ImU32 ink = color::text) {
    alignRight(text.c_str());
    plainText(text, ink);
}

/// The size of a level relative to the base, as a bar behind its bytes.
void shareBar(double share) {
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {low.x + width * (1 - static_cast<float>(std::clamp(share, 0.0, 1.0))), low.y + line * 0.06F},
        {low.x + width, low.y + line * 0.94F}, color::lit);
}

void missingRow(int number) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    rightAligned(std::to_string(number), color::problem);
    noteItem(fmt::format("memory:level {}", number));
    ImGui::TableNextColumn();
    rightAligned(tr("missing"), color::problem);
    helpTip("The texture is incomplete for filters that use mipmaps and is drawn as if its unit were off.");
}

void drawLevels(const LevelsSummary& summary, Target target) {
    const std::vector<LevelReport>& levels = summary.report.levels;
    const bool measured =
        std::ranges::any_of(levels, [](const LevelReport& level) { return level.psnr.has_value(); });
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("levels", measured ? 4 : 3, flags))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    constexpr std::array names{N_("Level"), N_("Texels"), N_("Bytes"), "PSNR"};
    ImGui::TableSetupColumn(names[0], ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize(tr(names[0])).x);
    ImGui::TableSetupColumn(names[1], ImGuiTableColumnFlags_WidthStretch, 1.2F);
    ImGui::TableSetupColumn(names[2], ImGuiTableColumnFlags_WidthStretch, 1.2F);
    if (measured)
        ImGui::TableSetupColumn(names[3], ImGuiTableColumnFlags_WidthStretch, 0.8F);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int column = 0; column < (measured ? 4 : 3); ++column) {
        ImGui::TableSetColumnIndex(column);
        const char* name = names.at(static_cast<std::size_t>(column));
        alignRight(tr(name));
        ImGui::TableHeader(label(name));
        if (column == 3)
            helpTip("The similarity of the compressed level to its source over all components. Differences "
                    "are hardly visible above 40 dB and clearly visible below 30 dB.");
    }
    const double base = levels.empty() ? 1 : static_cast<double>(std::max<std::size_t>(1, levels[0].bytes));
    int next = levels.empty() ? 0 : levels.front().number;
    for (const LevelReport& level : levels) {
        for (; next < level.number; ++next)
            missingRow(next);
        next = level.number + 1;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        rightAligned(std::to_string(level.number), color::dim);
        noteItem(fmt::format("memory:level {}", level.number));
        ImGui::TableNextColumn();
        const std::string extents = levelExtentsText(level, target);
        rightAligned(level.faces > 1 ? fmt::format("{} × {}", level.faces, extents) : extents);
        ImGui::TableNextColumn();
        shareBar(static_cast<double>(level.bytes) / base);
        rightAligned(grouped(level.bytes));
        if (measured) {
            ImGui::TableNextColumn();
            if (level.psnr)
                rightAligned(std::isinf(*level.psnr) ? tr("exact") : fmt::format("{:.1f} dB", *level.psnr));
        }
    }
    ImGui::EndTable();
}

} // namespace

const view::StoredTexture* storedOf(const Session& session, const Pictures& pictures) {
    const Unit& unit = selectedUnit(session);
    for (const ViewFrame& view : pictures.frames) {
        const auto found = view.frame.stored.find({static_cast<std::size_t>(unit.texture), unit.target});
        if (view.side == view::Side::Now && found != view.frame.stored.end() &&
            !found->second->levels.empty())
            return found->second.get();
    }
    return nullptr;
}

Sentence storedLevelText(const view::StoredLevel& level) {
    return level.bytes > 0 ? Sentence("{0}, {1} bytes", ProperName{level.internalFormat},
                                      ProperName{grouped(level.bytes)})
                           : view::storedText(level);
}

void drawMemoryTab(const Session& session, const Pictures& pictures) {
    const std::optional<LevelsRequest> request = requestLevels(session);
    if (!request)
        return;
    const std::shared_ptr<const LevelsSummary> summary = summaryOf(session, *request);
    if (summary && summary->problem.empty())
        drawSum(*boundTexture(session), *summary);
    else if (summary) {
        wrappedText(summary->problem, color::problem);
    } else if (workers(session).levels->isCancelled(*request)) {
        wrappedText("Making the levels was cancelled. The previous picture stays.");
        if (ImGui::Button(label("Make them")))
            act(session, [request](Session& changed) { workers(changed).levels->retry(*request); });
        noteItem("memory:retry");
    } else {
        dimText("The levels are being made…");
        noteItem("memory:waiting");
    }
    if (const view::StoredTexture* stored = storedOf(session, pictures))
        drawStored(*stored, request->target);
    drawSentences(sentencesOf(session, pictures, summary.get()));
    if (summary && !summary->report.levels.empty())
        drawLevels(*summary, request->target);
}

} // namespace texplorer::ui

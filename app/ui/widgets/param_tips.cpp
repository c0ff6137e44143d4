#include "app/ui/widgets/param_tips.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/tip.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

/// The frame in which a choice has shown its tip, which its row then need not show.
struct ToldChoice {
    int frame = -1;
    bool below = false; ///< in the status bar, not as a tooltip
};
ToldChoice toldChoice;

/// "since OpenGL 1.4", or the extension that defines it.
std::string originOf(const EnumRow& choice) {
    const bool extension = choice.since.starts_with("GL_");
    return extension ? fmt::format("from {}", choice.since) : fmt::format("since OpenGL {}", choice.since);
}

/// "GL_REPEAT · since OpenGL 1.0"; empty for names that are not OpenGL's.
std::string nameAndOrigin(const EnumRow& choice) {
    return choice.since.empty() ? std::string() : fmt::format("{} · {}", choice.name, originOf(choice));
}

std::string howToReset(const ParamRow& row, const Value& initial, bool hasSign) {
    const std::string words = formatValue(row, initial);
    return hasSign ? fmt::format("Initially {}; ↺ resets it.", words)
                   : fmt::format("Initially {}; right-click to reset.", words);
}

/// In one line of the status bar, the most important first. Returns true if the necessary parts fit.
bool hintParam(const ParamRow& row, const Value& value, const Value& initial, Target target,
               const Finding* idle, const Finding* problem, bool hasSign) {
    const bool isWrong = problem && problem->severity <= Severity::Warning;
    std::string words = idle      ? fmt::format("No effect now: {}.", idle->sentence)
                        : problem ? sentenceOf(*problem)
                                  : std::string(row.help);
    if (!fitsBelow(words))
        return false;
    const auto add = [&words](const std::string& more) {
        if (std::string longer = words + "  ·  " + more; !more.empty() && fitsBelow(longer))
            words = std::move(longer);
    };
    if (idle || problem)
        add(std::string(row.help));
    add(formatCall(row, value, target));
    if (value != initial)
        add(howToReset(row, initial, hasSign));
    hint(std::move(words), idle || isWrong);
    return true;
}

/// In one line of the status bar, with its names if they fit. Returns true if the help fits.
bool hintChoice(const EnumRow& choice) {
    const std::string names = choice.since.empty() ? std::string(choice.label)
                                                   : fmt::format("{}  ·  {}", choice.label, choice.name);
    for (const std::string& words :
         {fmt::format("{}  ·  {}", names, choice.help), std::string(choice.help)}) {
        if (!fitsBelow(words))
            continue;
        hint(words);
        return true;
    }
    return false;
}

} // namespace

void paramTip(const ParamRow& row, const Value& value, const Value& initial, Target target,
              const Finding* idle, const Finding* problem, bool hasSign) {
    if (!wantsHelp())
        return;
    const bool told = toldChoice.frame == ImGui::GetFrameCount() && !idle && !problem;
    if (told && toldChoice.below)
        return;
    if (hintParam(row, value, initial, target, idle, problem, hasSign) || told)
        return;
    if (ImGui::IsItemHovered() && hasJustClicked())
        return;
    std::vector<TipLine> lines;
    const auto add = [&lines](std::string words, ImU32 ink) { lines.push_back({std::move(words), ink}); };
    if (const std::string call = formatCall(row, value, target); !call.empty())
        lines.push_back({call, color::text, true});
    add(tr(row.help), color::text);
    if (row.kind == Kind::Text && !std::get<std::string>(value).empty())
        add(printable(std::get<std::string>(value)), color::dim); // the field shows the beginning
    if (row.kind == Kind::Enum) {
        if (const EnumRow* choice = findRow(row.choices, std::get<EnumValue>(value).number)) {
            add(fmt::format("{}: {}", tr(choice->label), tr(choice->help)), color::dim);
            if (!choice->since.empty())
                add(tr(nameAndOrigin(*choice)), color::dim);
        }
    }
    if (row.kind == Kind::Int || row.kind == Kind::Float || row.kind == Kind::Vec3 || row.kind == Kind::Vec4)
        add(tr("Drag it, or double-click to type a number."), color::dim);
    if (problem)
        add(tr(sentenceOf(*problem)), problem->severity <= Severity::Warning ? color::problem : color::text);
    if (idle)
        add(tr(Sentence("No effect now: {0}.", idle->sentence)), color::problem);
    if (value != initial)
        add(tr(howToReset(row, initial, hasSign)), color::changed);
    showTip(lines);
}

void choiceTip(const EnumRow& choice) {
    if (!ImGui::IsItemHovered())
        return;
    toldChoice = {ImGui::GetFrameCount(), hintChoice(choice)};
    if (toldChoice.below || hasJustClicked())
        return;
    std::vector<TipLine> lines{{tr(choice.label)}, {tr(choice.help)}};
    if (!choice.since.empty())
        lines.push_back({tr(nameAndOrigin(choice)), color::dim});
    showTip(lines);
}

} // namespace texplorer::ui

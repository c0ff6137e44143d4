#include "app/ui/widgets/param_tips.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/tip.h"
#include "texplorer/scene/params/value_words.h"
#include "texplorer/text/printable.h"

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
Sentence originOf(const EnumRow& choice) {
    const ProperName since{choice.since};
    return choice.since.starts_with("GL_") ? Sentence("from {0}", since)
                                           : Sentence("since OpenGL {0}", since);
}

/// "GL_REPEAT · since OpenGL 1.0"; empty for names that are not OpenGL's.
Sentence nameAndOrigin(const EnumRow& choice) {
    return choice.since.empty() ? Sentence()
                                : Sentence("{0} · {1}", ProperName{choice.name}, originOf(choice));
}

Sentence howToReset(const ParamRow& row, const Value& initial, bool hasSign) {
    const Sentence words = wordsOf(row, initial);
    return hasSign ? Sentence("Initially {0}; ↺ resets it.", words)
                   : Sentence("Initially {0}; right-click to reset.", words);
}

/// In one line of the status bar, the most important first. Returns true if the necessary parts fit.
bool hintParam(const ParamRow& row, const Value& value, const Value& initial, Target target,
               const Finding* idle, const Finding* problem, bool hasSign) {
    const bool isWrong = problem && problem->severity <= Severity::Warning;
    Sentence words = idle      ? Sentence("No effect now: {0}.", idle->sentence)
                     : problem ? shownSentence(problem->sentence)
                               : Sentence(row.help);
    if (!fitsBelow(words))
        return false;
    const auto add = [&words](const Sentence& more) {
        if (Sentence longer("{0}  ·  {1}", words, more); !more.empty() && fitsBelow(longer))
            words = std::move(longer);
    };
    if (idle || problem)
        add(row.help);
    add(ProperName{formatCall(row, value, target)});
    if (value != initial)
        add(howToReset(row, initial, hasSign));
    hint(std::move(words), idle || isWrong);
    return true;
}

/// In one line of the status bar, with its names if they fit. Returns true if the help fits.
bool hintChoice(const EnumRow& choice) {
    const Sentence names = choice.since.empty()
                               ? Sentence(choice.label)
                               : Sentence("{0}  ·  {1}", choice.label, ProperName{choice.name});
    for (const Sentence& words : {Sentence("{0}  ·  {1}", names, choice.help), Sentence(choice.help)}) {
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
    const bool isTold = toldChoice.frame == ImGui::GetFrameCount(); // by the tip of a choice
    if (isTold && toldChoice.below && !idle && !problem)
        return;
    if (hintParam(row, value, initial, target, idle, problem, hasSign) || isTold)
        return;
    if (ImGui::IsItemHovered() && hasJustClicked())
        return;
    std::vector<TipLine> lines;
    const auto add = [&lines](const Sentence& words, ImU32 ink) { lines.push_back({tr(words), ink}); };
    if (const std::string call = formatCall(row, value, target); !call.empty())
        lines.push_back({call, color::text, true});
    add(row.help, color::text);
    if (row.kind == Kind::Text && !std::get<std::string>(value).empty())
        add(ProperName{printable(std::get<std::string>(value))}, color::dim); // the field shows the beginning
    if (row.kind == Kind::Enum) {
        if (const EnumRow* choice = findRow(row.choices, std::get<EnumValue>(value).number)) {
            add(Sentence("{0}: {1}", choice->label, choice->help), color::dim);
            if (!choice->since.empty())
                add(nameAndOrigin(*choice), color::dim);
        }
    }
    if (row.kind == Kind::Int || row.kind == Kind::Float || row.kind == Kind::Vec3 || row.kind == Kind::Vec4)
        add(N_("Drag it, or double-click to type a number."), color::dim);
    if (problem)
        add(shownSentence(problem->sentence),
            problem->severity <= Severity::Warning ? color::problem : color::text);
    if (idle)
        add(Sentence("No effect now: {0}.", idle->sentence), color::problem);
    if (value != initial)
        add(howToReset(row, initial, hasSign), color::changed);
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

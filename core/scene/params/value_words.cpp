#include "texplorer/scene/params/value_words.h"

namespace texplorer {

Sentence wordsOf(const EnumRow& choice) {
    return choice.since.empty() ? Sentence(choice.label) : Sentence(ProperName{choice.name});
}

Sentence wordsOf(const ParamRow& row, const Value& value) {
    if (const auto* chosen = std::get_if<EnumValue>(&value)) {
        if (const EnumRow* choice = findRow(row.choices, chosen->number))
            return wordsOf(*choice);
    }
    if (const bool* isOn = std::get_if<bool>(&value))
        return *isOn ? N_("on") : N_("off");
    const std::string words = formatValue(row, value);
    return ProperName{words};
}

} // namespace texplorer

#include "tests/ui/language/said.h"

#include "app/ui/language/po_file.h"
#include "app/ui/language/translate.h"
#include "tests/ui/english_words.h"

#include <algorithm>

namespace texplorer::test {
namespace {

/// The keys of a sentence and of those in it.
void addKeys(const Sentence& sentence, std::set<std::string>& keys) {
    if (sentence.isName() || sentence.isNumber())
        return;
    keys.emplace(sentence.key().empty() ? std::string_view(sentence) : sentence.key());
    for (const Sentence& each : sentence.arguments())
        addKeys(each, keys);
}

/// The texts of the catalogues that come from a folder or a file of the sources.
std::set<std::string> textsOf(std::string_view source) {
    std::set<std::string> texts;
    std::string_view rest = ui::catalogueFiles().front().text;
    while (!rest.empty()) {
        const std::string_view entry = rest.substr(0, rest.find("\n\n"));
        rest.remove_prefix(std::min(entry.size() + 2, rest.size()));
        if (entry.find(std::string("#: ").append(source)) == std::string_view::npos)
            continue;
        const std::vector<ui::PoEntry> entries = ui::readPoFile(entry, "catalogue").value();
        for (const ui::PoEntry& each : entries)
            texts.insert(each.key);
    }
    return texts;
}

std::string withoutNames(std::string text, const Sentence& sentence) {
    const std::size_t at = sentence.isName() ? text.find(sentence.english()) : std::string::npos;
    if (at != std::string::npos)
        text.replace(at, sentence.english().size(), "-");
    for (const Sentence& each : sentence.arguments())
        text = withoutNames(std::move(text), each);
    return text;
}

} // namespace

bool Said::add(const Sentence& sentence) {
    if (sentence.empty())
        return false;
    std::set<std::string> keys;
    addKeys(sentence, keys);
    const auto isNew = [this](const std::string& key) { return !keys_.contains(key); };
    const bool hasNew = std::ranges::any_of(keys, isNew);
    if (hasNew)
        sentences_.push_back(sentence);
    keys_.merge(keys);
    return hasNew;
}

std::string Said::unsaidOf(std::string_view source) const {
    std::string list;
    for (const std::string& text : textsOf(source)) {
        if (!keys_.contains(text))
            list += "\n  " + text;
    }
    return list;
}

std::string Said::english() const {
    std::string list;
    for (const Sentence& each : sentences_) {
        const std::string shown = ui::tr(each);
        if (const std::string words = englishWords(withoutNames(shown, each)); !words.empty())
            list += "\n  " + words + ": " + shown;
    }
    return list;
}

} // namespace texplorer::test

#include "app/ui/language/catalogue.h"

#include "app/ui/language/po_file.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
Result<void> Catalogue::read(const CatalogueFile& file) {
    const Result<std::vector<PoEntry>> entries = readPoFile(file.text, file.name);
    if (!entries)
        return fail(entries.error());
    for (const PoEntry& entry : *entries) {
        if (entry.key.empty() || !entry.isTranslated())
            continue;
        for (const std::string& form : entry.forms)
            letters_ += form;
        for (const std::string& key : {entry.key, entry.pluralKey})
            entries_.emplace(key, entry.forms);
    }
    entries_.erase("");
    return {};
}

Result<Catalogue> Catalogue::parse(Language language, std::span<const CatalogueFile> files) {
    Catalogue catalogue;
    catalogue.language_ = language;
    for (const CatalogueFile& file : files) {
        if (Result<void> done = catalogue.read(file); !done)
            return fail(done.error());
    }
    return catalogue;
}

std::string textIn(const Catalogue* catalogue, const Sentence& english) {
    return catalogue ? catalogue->translate(english) : english.english();
}

Result<std::unique_ptr<const Catalogue>> catalogueOf(Language language) {
    if (language == Language::System || language == Language::English)
        return nullptr;
    const auto file = std::ranges::find(catalogueFiles(), catalogueFileOf(language), &CatalogueFile::name);
    return Catalogue::parse(language, std::span(file, file == catalogueFiles().end() ? 0 : 1))
        .map([](Catalogue catalogue) {
            return std::unique_ptr<const Catalogue>(std::make_unique<Catalogue>(std::move(catalogue)));
        });
}

std::set<std::string> Catalogue::keys() const {
    std::set<std::string> keys;
    for (const auto& [key, forms] : entries_)
        keys.insert(key);
    return keys;
}

const std::string* Catalogue::find(std::string_view english) const {
    const auto found = entries_.find(english);
    return found == entries_.end() ? nullptr : &found->second.front();
}

std::string Catalogue::translate(const Sentence& sentence,
                                 const std::function<void(std::string_view)>& gap) const {
    if (sentence.isName() || sentence.isNumber())
        return sentence.english();
    if (sentence.key().empty()) {
        const std::string* text = find(sentence.english());
        return text ? *text : sentence.english();
    }
    const auto argument = [&](const Sentence& each) { return translate(each, gap); };
    const auto found = entries_.find(sentence.key());
    if (found == entries_.end() && gap)
        gap(sentence.english());
    if (found == entries_.end())
        return sentence.in(sentence.key(), argument);
    const Forms& forms = found->second;
    const std::size_t form = rowOf(language_).form(sentence.arguments().front().number().value_or(1));
    return sentence.in(forms[std::min(form, forms.size() - 1)], argument);
}

} // namespace texplorer::ui

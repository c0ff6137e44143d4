#pragma once

#include "app/ui/language/language.h"
#include "texplorer/base/result.h"

#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace texplorer::ui {

/// A file of assets/translations, compiled in: "ru.po".
struct CatalogueFile {
    std::string_view name;
    std::string_view text;
};

[[nodiscard]] const std::vector<CatalogueFile>& catalogueFiles();

class Catalogue;

/// A text in a catalogue's language, see Catalogue::translate; English without a catalogue.
[[nodiscard]] std::string textIn(const Catalogue* catalogue, const Sentence& english);

/// The catalogue of a language; nullptr for English. Fails as Catalogue::parse does.
[[nodiscard]] Result<std::unique_ptr<const Catalogue>> catalogueOf(Language language);

/// The texts of a language, from gettext's .po files: the English text is the key. A key may have
/// placeholders, "{0}", for inserted values; a translation has the same ones.
class Catalogue {
public:
    /// Fails as readPoFile does. Untranslated and fuzzy entries are skipped.
    [[nodiscard]] static Result<Catalogue> parse(Language language, std::span<const CatalogueFile> files);

    /// The translation of a text that is a key itself; nullptr: none.
    [[nodiscard]] const std::string* find(std::string_view english) const;

    /// Translates a sentence by its key, and its arguments unless they are names or numbers. Without a
    /// translation it stays English, and `gap` is called with its text. An argument that is no key is
    /// unchanged.
    [[nodiscard]] std::string translate(const Sentence& sentence,
                                        const std::function<void(std::string_view)>& gap = {}) const;

    /// All keys with a translation.
    [[nodiscard]] std::set<std::string> keys() const;

    /// All texts of the translations, to find the letters that a font needs.
    [[nodiscard]] const std::string& letters() const { return letters_; }

    [[nodiscard]] Language language() const { return language_; }

private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
    };
    using Forms = std::vector<std::string>; ///< one for each plural form

    Result<void> read(const CatalogueFile& file);

    Language language_ = Language::English;
    std::unordered_map<std::string, Forms, Hash, std::equal_to<>> entries_;
    std::string letters_;
};

} // namespace texplorer::ui

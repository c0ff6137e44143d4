#pragma once

#include "app/ui/language/language.h"
#include "core/base/result.h"

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// A file of assets/translations, compiled in: "ru/window.po".
struct CatalogueFile {
    std::string_view name;
    std::string_view text;
};

[[nodiscard]] const std::vector<CatalogueFile>& catalogueFiles();

class Catalogue;

/// Those of a language, read; English has none. Malformed: see Catalogue::parse.
[[nodiscard]] Result<std::unique_ptr<const Catalogue>> catalogueOf(Language language);

/// Names that the user, or a file, gave: no words of the program.
using Names = std::set<std::string, std::less<>>;

/// The texts of a language, from gettext's .po files: the English text is the key. A key may have places,
/// "{}", for what the program puts in; a translation has as many, or numbers them, "{1} of {0}". So core
/// writes its sentences in English and knows of no language: the window translates the sentence that it is
/// about to show.
class Catalogue {
public:
    /// Malformed: what no .po file is, with the line; a translation whose places are not those of its key.
    /// What isn't translated yet, or is marked as fuzzy, is left out.
    [[nodiscard]] static Result<Catalogue> parse(Language language, std::span<const CatalogueFile> files);

    /// An English text in this language; nothing where none of it has a translation. Looked up are the text
    /// itself, as a key, then as what a key with places became, whose parts are translated in their turn,
    /// then its parts: lines, sentences, what " · " or a colon separates. A part that is one of `names`
    /// stays.
    [[nodiscard]] std::optional<std::string> translate(std::string_view english,
                                                       const Names& names = {}) const;

    /// Every key that has a translation, each of its places as "{}", and a text as such a key.
    [[nodiscard]] std::set<std::string> keys() const;
    [[nodiscard]] static std::string keyOf(std::string_view text);

    /// Every text that a translation is made of, for a font that has its letters.
    [[nodiscard]] const std::string& letters() const { return letters_; }

    [[nodiscard]] Language language() const { return language_; }

private:
    /// How much a key says without its places: letters, then bytes.
    using Said = std::pair<std::size_t, std::size_t>;

    struct Entry {
        std::vector<std::string> pieces; ///< of the key, between its places
        std::vector<std::string> forms;  ///< the translation, for each form of a number
        bool counts = false;             ///< its first place is a number, which the form follows
        bool hasLines = false;           ///< else each line of a text has a key of its own

        /// Whether it begins with a place, and so with anything.
        [[nodiscard]] bool isOpen() const { return pieces.front().empty(); }
        [[nodiscard]] bool beginsWithPlaceAndColon() const;
        [[nodiscard]] Said says() const;
    };

    /// The keys that a text is held against together.
    enum class Keys { Closed, Open };

    /// How deep a part lies, and what all parts together may still cost: there are more ways to divide a text
    /// that is made for it than anybody can wait for.
    struct Search {
        int depth;
        std::size_t* left;
        const Names* names;

        [[nodiscard]] Search deeper() const { return {depth + 1, left, names}; }
    };

    /// A text as what a key with places became.
    struct Reading {
        const Entry* entry = nullptr;
        std::vector<std::string_view> parts; ///< what stands at its places
    };

    struct Draft;

    Result<void> add(const Draft& draft, std::string_view file);
    void addKey(std::string_view key, const Draft& draft);
    [[nodiscard]] std::optional<std::string> lookUp(std::string_view english, Search search) const;
    [[nodiscard]] std::optional<std::string> fromKeys(std::string_view english, Search search) const;
    [[nodiscard]] Said saysOf(std::string_view english) const;
    [[nodiscard]] Reading read(Keys keys, std::string_view english) const;
    [[nodiscard]] std::string translationOf(const Reading& reading, Search search) const;
    [[nodiscard]] std::optional<std::string> afterPlace(std::string_view english, Search search) const;
    [[nodiscard]] std::optional<std::string> fromParts(std::string_view english, Search search) const;
    [[nodiscard]] std::optional<std::string> joined(std::string_view english, std::string_view separator,
                                                    Search search) const;

    Language language_ = Language::English;
    std::unordered_map<std::string, std::string> whole_; ///< what has no places
    std::vector<Entry> entries_;                         ///< what has, the most letters first
    std::string letters_;
};

} // namespace texplorer::ui

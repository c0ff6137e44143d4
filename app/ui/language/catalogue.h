#pragma once

#include "app/ui/language/language.h"
#include "texplorer/base/result.h"

#include <functional>
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

/// The catalogue of a language; nullptr for English. Fails as Catalogue::parse does.
[[nodiscard]] Result<std::unique_ptr<const Catalogue>> catalogueOf(Language language);

/// Names given by the user or a file, which are not translated.
using Names = std::set<std::string, std::less<>>;

/// The texts of a language, from gettext's .po files: the English text is the key. A key may have
/// placeholders, "{}", for inserted values; a translation has the same ones, or numbers them, "{1} of {0}".
/// The core writes sentences in English and does not know about languages: the window translates each
/// sentence when it shows it.
class Catalogue {
public:
    /// Fails for an invalid .po file, with the line, and for a translation whose placeholders do not match
    /// its key. Untranslated and fuzzy entries are skipped.
    [[nodiscard]] static Result<Catalogue> parse(Language language, std::span<const CatalogueFile> files);

    /// Translates an English text; nothing if no part of it has a translation. It looks up the text itself as
    /// a key, then as a key with placeholders whose values are translated as well, then its parts: lines,
    /// sentences, and what " · " or a colon separates. A part that is one of `names` stays unchanged.
    [[nodiscard]] std::optional<std::string> translate(std::string_view english,
                                                       const Names& names = {}) const;

    /// Translates a sentence by its key, and its arguments by `word` unless they are names. Without a
    /// translation the key itself is used, and `gap` is called if it has words.
    [[nodiscard]] std::string translate(const Sentence& sentence,
                                        const std::function<std::string(std::string_view)>& word,
                                        const std::function<void(std::string_view)>& gap) const;

    /// All keys with a translation, with their placeholders as "{}"; and a text as such a key.
    [[nodiscard]] std::set<std::string> keys() const;
    [[nodiscard]] static std::string keyOf(std::string_view text);

    /// All texts of the translations, to find the letters that a font needs.
    [[nodiscard]] const std::string& letters() const { return letters_; }

    [[nodiscard]] Language language() const { return language_; }

private:
    /// How specific a key is without its placeholders: letters, then bytes.
    using Said = std::pair<std::size_t, std::size_t>;

    struct Entry {
        std::vector<std::string> pieces; ///< of the key, between its placeholders
        std::vector<std::string> forms;  ///< the translations, one for each plural form
        Said says;                       ///< of the key
        bool counts = false;             ///< its first placeholder is a number, which selects the form
        bool hasLines = false;           ///< false: each line of a text has its own key

        /// Whether it begins with a placeholder, and so may match any text.
        [[nodiscard]] bool isOpen() const { return pieces.front().empty(); }
    };

    /// Groups of keys that a text is compared with together.
    enum class Keys { Closed, Open };

    /// The depth of a part, and the remaining effort for all parts together: a malicious text can be divided
    /// in too many ways to try all.
    struct Search {
        int depth;
        std::size_t* left;
        const Names* names;

        [[nodiscard]] Search deeper() const { return {depth + 1, left, names}; }
    };

    /// A text that matches a key with placeholders.
    struct Reading {
        const Entry* entry = nullptr;
        std::vector<std::string_view> parts; ///< the texts at its placeholders
    };

    struct Draft;

    Result<void> read(const CatalogueFile& file);
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
    std::unordered_map<std::string, std::string> whole_; ///< keys without placeholders
    std::vector<Entry> entries_; ///< keys with placeholders, the one with most letters first
    std::unordered_map<std::string, std::size_t> indices_; ///< of `entries_`, by the key with "{}"
    std::string letters_;
};

} // namespace texplorer::ui

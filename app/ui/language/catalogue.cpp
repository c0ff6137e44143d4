#include "app/ui/language/catalogue.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ranges>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr int maxPartDepth = 6;
constexpr std::size_t minEffort =
    100; ///< for a part, in addition to its bytes, which are compared with all keys
constexpr std::size_t maxEffort = 100'000; ///< for a text: several times the effort of any of ours
constexpr std::size_t keysOfEffort = 16;   ///< this many keys with placeholders cost as much as a byte
constexpr std::size_t maxPlaces = 32;      ///< of a key
constexpr std::string_view colon = ": ";
constexpr std::size_t minLetters = 3; ///< of a key with placeholders: "{} × {}" is too general

/// A text with placeholders: "a {} b {0}" → "a ", " b ", "" and 0, 0.
struct Divided {
    std::vector<std::string> pieces{1};
    std::vector<std::size_t> places{}; ///< the index of the value: "{}" takes the next one, "{1}" the second
};

/// A format such as {:.2f} is a placeholder, and {{ a brace. Without a closing brace there are none.
Divided divided(std::string_view text) {
    Divided parts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((text[i] == '{' || text[i] == '}') && i + 1 < text.size() && text[i + 1] == text[i]) {
            parts.pieces.back() += text[i++];
        } else if (text[i] == '{') {
            const std::size_t end = text.find('}', i);
            if (end == std::string_view::npos)
                return {{std::string(text)}};
            std::size_t& index = parts.places.emplace_back(parts.places.size());
            std::from_chars(text.data() + i + 1, text.data() + end, index);
            parts.pieces.emplace_back();
            i = end;
        } else {
            parts.pieces.back() += text[i];
        }
    }
    return parts;
}

bool isLetter(char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

/// The number of letters and of all bytes; the bytes decide between keys with equally many letters.
std::pair<std::size_t, std::size_t> saidBy(const std::vector<std::string>& pieces) {
    std::pair<std::size_t, std::size_t> said;
    for (const std::string& piece : pieces) {
        said.first += static_cast<std::size_t>(std::ranges::count_if(piece, isLetter));
        said.second += piece.size();
    }
    return said;
}

/// Returns the texts at the placeholders if `text` matches the key; each is as short as possible. `tries`
/// limits the cost of a malicious text.
bool match(std::string_view text, std::span<const std::string> pieces, std::vector<std::string_view>& parts,
           int& tries) {
    if (pieces.size() == 1) {
        if (!text.ends_with(pieces.front()))
            return false;
        parts.push_back(text.substr(0, text.size() - pieces.front().size()));
        return true;
    }
    for (std::size_t at = text.find(pieces.front()); at != std::string_view::npos && --tries > 0;
         at = text.find(pieces.front(), at + 1)) {
        parts.push_back(text.substr(0, at));
        if (match(text.substr(at + pieces.front().size()), pieces.subspan(1), parts, tries))
            return true;
        parts.pop_back();
        if (pieces.front().empty())
            return false; // two adjacent placeholders: the boundary between them is unknown
    }
    return false;
}

std::optional<std::vector<std::string_view>> partsOf(std::string_view text,
                                                     std::span<const std::string> pieces) {
    if (!text.starts_with(pieces.front()))
        return std::nullopt;
    std::vector<std::string_view> parts;
    int tries = 200;
    if (!match(text.substr(pieces.front().size()), pieces.subspan(1), parts, tries))
        return std::nullopt;
    return parts;
}

/// Inserts parts into a translation.
std::string filled(std::string_view form, std::span<const std::string> parts) {
    const auto [pieces, places] = divided(form);
    std::string text = pieces.front();
    for (std::size_t i = 0; i < places.size(); ++i)
        text += (places[i] < parts.size() ? parts[places[i]] : std::string()) + pieces[i + 1];
    return text;
}

/// Whether a translation has every placeholder of its key exactly once, by order or by number.
bool hasPlaces(std::string_view form, std::size_t count) {
    std::vector<std::size_t> places = divided(form).places;
    std::ranges::sort(places);
    return std::ranges::equal(places, std::views::iota(std::size_t{0}, count));
}

std::optional<unsigned long> numberIn(std::string_view part) {
    unsigned long number = 0;
    const char* end = part.data() + part.size();
    return std::from_chars(part.data(), end, number).ptr == end ? std::optional(number) : std::nullopt;
}

unsigned long countIn(const Sentence& argument) {
    return argument.number().value_or(numberIn(argument).value_or(0));
}

constexpr char32_t caseDistance = 0x20; // in ASCII and in Russian

bool isCapital(char32_t letter) {
    return (letter >= U'A' && letter <= U'Z') || (letter >= U'А' && letter <= U'Я');
}

/// Replaces the first letter of a text; both have at most 11 bits.
std::string withFirst(std::string_view text, char32_t letter) {
    const auto byte = [](char32_t bits) { return static_cast<char>(bits); };
    std::string first = letter < 0x80 ? std::string{byte(letter)}
                                      : std::string{byte(0xC0 | (letter >> 6)), byte(0x80 | (letter & 0x3F))};
    return first.append(text.substr(firstCharacter(text).bytes));
}

std::string withCapital(std::string_view text) {
    const char32_t capital = firstCharacter(text).character - caseDistance;
    return isCapital(capital) ? withFirst(text, capital) : std::string(text);
}

/// Not for a name with several capitals: "GL_REPEAT".
std::string withoutCapital(std::string_view text) {
    const char32_t first = firstCharacter(text).character;
    const bool isName = first < 0x80 && (text.size() < 2 || (text[1] >= 'A' && text[1] <= 'Z'));
    return isCapital(first) && !isName ? withFirst(text, first + caseDistance) : std::string(text);
}

/// The text of a quoted line: "msgid \"a\\n\"" → a and a newline.
std::optional<std::string> quoted(std::string_view line) {
    const std::size_t begin = line.find('"');
    const std::size_t end = line.rfind('"');
    if (begin == std::string_view::npos || begin == end)
        return std::nullopt;
    std::string text;
    for (std::size_t i = begin + 1; i < end; ++i) {
        if (line[i] != '\\') {
            text += line[i];
            continue;
        }
        if (++i == end)
            return std::nullopt;
        text += line[i] == 'n' ? '\n' : line[i] == 't' ? '\t' : line[i];
    }
    return text;
}

} // namespace

/// An entry while its lines are read.
struct Catalogue::Draft {
    std::optional<std::string> key;
    std::optional<std::string> pluralKey;
    std::vector<std::string> forms;
    bool isFuzzy = false;
    std::size_t line = 0;
};

void Catalogue::addKey(std::string_view key, const Draft& draft) {
    std::vector<std::string> pieces = divided(key).pieces;
    const Said says = saidBy(pieces);
    if (pieces.size() == 1)
        whole_.emplace(pieces.front(), filled(draft.forms.front(), {}));
    else if (says.first >= minLetters)
        entries_.push_back({std::move(pieces), draft.forms, says, draft.pluralKey.has_value(),
                            key.find('\n') != std::string_view::npos});
}

Result<void> Catalogue::add(const Draft& draft, std::string_view file) {
    if (!draft.key || draft.key->empty() || draft.isFuzzy)
        return {};
    const auto isMissing = [](const std::string& form) { return form.empty(); };
    if (draft.forms.empty() || std::ranges::any_of(draft.forms, isMissing))
        return {};
    const std::size_t places = divided(*draft.key).places.size();
    if (places > maxPlaces)
        return fail(ErrorCode::Malformed,
                    Sentence("expected a text with at most {0} places, found {1}", maxPlaces, places),
                    fmt::format("{}:{}", file, draft.line));
    for (const std::string& form : draft.forms) {
        if (!hasPlaces(form, places))
            return fail(ErrorCode::Malformed,
                        Sentence("expected a translation with {0} places, found {1}", places, inQuotes(form)),
                        fmt::format("{}:{}", file, draft.line));
        letters_ += form;
    }
    addKey(*draft.key, draft);
    if (draft.pluralKey && draft.pluralKey != draft.key)
        addKey(*draft.pluralKey, draft);
    return {};
}

Result<void> Catalogue::read(const CatalogueFile& file) {
    Draft draft;
    std::string* last = nullptr;
    const auto finish = [&]() -> Result<void> {
        if (!draft.key || draft.forms.empty())
            return {};
        last = nullptr;
        return add(std::exchange(draft, {}), file.name);
    };
    std::size_t number = 0;
    for (std::size_t from = 0; from <= file.text.size();) {
        const std::size_t end = std::min(file.text.find('\n', from), file.text.size());
        const std::string_view line = file.text.substr(from, end - from);
        from = end + 1;
        ++number;
        const bool endsEntry = line.empty() || line.starts_with("#");
        std::optional<std::string> text = quoted(line);
        if (endsEntry || (text && line.starts_with("msgid "))) {
            if (Result<void> added = finish(); !added)
                return added;
        }
        if (endsEntry) {
            draft.isFuzzy |= line.starts_with("#,") && line.find("fuzzy") != std::string_view::npos;
        } else if (text && line.starts_with("msgid_plural ") && draft.key) {
            last = &draft.pluralKey.emplace(*std::move(text));
        } else if (text && line.starts_with("msgid ")) {
            draft.line = number;
            last = &draft.key.emplace(*std::move(text));
        } else if (text && line.starts_with("msgstr") && draft.key) {
            last = &draft.forms.emplace_back(*std::move(text));
        } else if (text && line.starts_with("\"") && last) {
            *last += *text;
        } else {
            return fail(ErrorCode::Malformed, "expected a line of a .po file, msgid or msgstr with its text",
                        fmt::format("{}:{}", file.name, number));
        }
    }
    return finish();
}

Result<Catalogue> Catalogue::parse(Language language, std::span<const CatalogueFile> files) {
    Catalogue catalogue;
    catalogue.language_ = language;
    for (const CatalogueFile& file : files) {
        if (Result<void> done = catalogue.read(file); !done)
            return fail(done.error());
    }
    // A text was most likely made from its most specific key.
    std::ranges::stable_sort(catalogue.entries_, std::greater<>(), &Entry::says);
    for (std::size_t i = 0; i < catalogue.entries_.size(); ++i)
        catalogue.indices_.emplace(fmt::format("{}", fmt::join(catalogue.entries_[i].pieces, "{}")), i);
    return catalogue;
}

Result<std::unique_ptr<const Catalogue>> catalogueOf(Language language) {
    if (language == Language::System || language == Language::English)
        return nullptr;
    std::vector<CatalogueFile> files;
    const std::string folder = std::string(rowOf(language).name) + "/";
    std::ranges::copy_if(catalogueFiles(), std::back_inserter(files),
                         [&](const CatalogueFile& file) { return file.name.starts_with(folder); });
    return Catalogue::parse(language, files).map([](Catalogue catalogue) {
        return std::unique_ptr<const Catalogue>(std::make_unique<Catalogue>(std::move(catalogue)));
    });
}

std::string Catalogue::keyOf(std::string_view text) {
    return fmt::format("{}", fmt::join(divided(text).pieces, "{}"));
}

std::set<std::string> Catalogue::keys() const {
    std::set<std::string> keys;
    for (const auto& [key, translation] : whole_)
        keys.insert(key);
    for (const Entry& entry : entries_)
        keys.insert(fmt::format("{}", fmt::join(entry.pieces, "{}")));
    return keys;
}

std::string Catalogue::translate(const Sentence& sentence,
                                 const std::function<std::string(std::string_view)>& word,
                                 const std::function<void(std::string_view)>& gap) const {
    if (sentence.isName() || sentence.number())
        return sentence.english();
    if (sentence.key().empty())
        return word(sentence.english());
    const auto [pieces, places] = divided(sentence.key());
    std::vector<std::string> parts; // in the order of the key's placeholders, as in translations
    for (const std::size_t place : places)
        parts.push_back(translate(sentence.arguments()[place], word, gap));
    const auto found = indices_.find(fmt::format("{}", fmt::join(pieces, "{}")));
    if (found == indices_.end()) {
        if (saidBy(pieces).first >= minLetters)
            gap(sentence.english());
        std::string text = pieces.front();
        for (std::size_t i = 0; i < parts.size(); ++i)
            text += parts[i] + pieces[i + 1];
        return text;
    }
    const Entry& entry = entries_[found->second];
    const std::size_t form =
        entry.counts ? rowOf(language_).form(countIn(sentence.arguments()[places.front()])) : 0;
    return filled(entry.forms[std::min(form, entry.forms.size() - 1)], parts);
}

std::optional<std::string> Catalogue::translate(std::string_view english, const Names& names) const {
    std::size_t left = maxEffort;
    return lookUp(english, {0, &left, &names});
}

std::optional<std::string> Catalogue::lookUp(std::string_view english, Search search) const {
    if (english.empty() || search.depth > maxPartDepth || std::ranges::none_of(english, isLetter))
        return std::nullopt;
    if (search.depth > 0 && search.names->contains(english))
        return std::nullopt;
    const std::size_t effort = std::max(minEffort, entries_.size() / keysOfEffort) + english.size();
    if (*search.left < effort)
        return std::nullopt;
    *search.left -= effort;
    // An indented line belongs to the line above it.
    if (const std::size_t indent = english.find_first_not_of(' '); indent > 0) {
        std::optional<std::string> text = lookUp(english.substr(indent), search.deeper());
        return text ? std::optional(std::string(indent, ' ') + *text) : std::nullopt;
    }
    if (std::optional<std::string> text = fromKeys(english, search))
        return text;
    return fromParts(english, search);
}

/// A sentence begins with a capital letter and its key may not, or the other way round: look both up in each
/// kind of key before the next kind.
std::optional<std::string> Catalogue::fromKeys(std::string_view english, Search search) const {
    const std::string small = withoutCapital(english);
    const bool hasCapital = small != english;
    const std::string other = hasCapital ? small : withCapital(english);
    const bool isOther = other != english;
    const auto restored = [hasCapital](std::string_view text) {
        return hasCapital ? withCapital(text) : withoutCapital(text);
    };
    if (const auto found = whole_.find(std::string(english)); found != whole_.end())
        return found->second;
    if (const auto found = whole_.find(other); found != whole_.end())
        return restored(found->second);
    const Reading given = read(Keys::Closed, english);
    const Reading turned = isOther ? read(Keys::Closed, other) : Reading();
    const std::string_view label = english.substr(0, english.find(colon)); // "Wrap s: Repeat"
    const Said labelSays = whole_.contains(std::string(label)) ? saidBy({std::string(label)}) : Said();
    if (turned.entry && turned.entry->says > std::max(given.entry ? given.entry->says : Said(), labelSays))
        return restored(translationOf(turned, search));
    if (given.entry)
        return translationOf(given, search);
    const Reading open = read(Keys::Open, english);
    if (open.entry && open.entry->pieces[1].starts_with(colon) &&
        open.entry->says > saysOf(english.substr(english.find(colon) + colon.size())))
        return translationOf(open, search);
    if (std::optional<std::string> text = afterPlace(english, search))
        return text;
    if (std::optional<std::string> text = isOther ? afterPlace(other, search) : std::nullopt)
        return restored(*std::move(text));
    return open.entry ? std::optional(translationOf(open, search)) : std::nullopt;
}

/// How specific the key of a text is; nothing if no key matches.
Catalogue::Said Catalogue::saysOf(std::string_view english) const {
    if (whole_.contains(std::string(english)))
        return saidBy({std::string(english)});
    const Reading closed = read(Keys::Closed, english);
    const Reading known = closed.entry ? closed : read(Keys::Open, english);
    return known.entry ? known.entry->says : Said();
}

/// Uses the most specific matching key.
Catalogue::Reading Catalogue::read(Keys keys, std::string_view english) const {
    const bool hasLines = english.find('\n') != std::string_view::npos;
    for (const Entry& entry : entries_) {
        if (entry.isOpen() != (keys == Keys::Open) || entry.hasLines != hasLines)
            continue;
        auto parts = partsOf(english, entry.pieces);
        if (!parts || (entry.counts && !numberIn(parts->front())))
            continue;
        return {&entry, *std::move(parts)};
    }
    return {};
}

std::string Catalogue::translationOf(const Reading& reading, Search search) const {
    const Entry& entry = *reading.entry;
    std::vector<std::string> words;
    for (const std::string_view part : reading.parts)
        words.push_back(lookUp(part, search.deeper()).value_or(std::string(part)));
    const std::size_t form =
        entry.counts ? rowOf(language_).form(numberIn(reading.parts.front()).value_or(0)) : 0;
    return filled(entry.forms[std::min(form, entry.forms.size() - 1)], words);
}

/// "textures[0]: …", "brick.bmp: …": the place, then the problem. Tried before keys that begin with a
/// placeholder, which would match both as one.
std::optional<std::string> Catalogue::afterPlace(std::string_view english, Search search) const {
    const std::size_t at = english.find(colon);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::string place(english.substr(0, at));
    const auto word =
        search.names->contains(place) ? whole_.end() : whole_.find(place); // a parameter's label
    if (word == whole_.end() && place.find_first_of(" \n") != std::string::npos)
        return std::nullopt;
    const std::optional<std::string> text = lookUp(english.substr(at + colon.size()), search.deeper());
    if (!text)
        return std::nullopt;
    return (word == whole_.end() ? place : word->second) + std::string(colon) + *text;
}

std::optional<std::string> Catalogue::joined(std::string_view english, std::string_view separator,
                                             Search search) const {
    std::size_t at = english.find(separator);
    if (at == std::string_view::npos)
        return std::nullopt;
    std::string text;
    bool isKnown = false;
    for (std::size_t from = 0;; at = english.find(separator, from)) {
        const std::string_view part = english.substr(from, at - from);
        const std::optional<std::string> known = lookUp(part, search.deeper());
        isKnown |= known.has_value();
        text += known.value_or(std::string(part));
        if (at == std::string_view::npos)
            break;
        text += separator;
        from = at + separator.size();
    }
    return isKnown ? std::optional(std::move(text)) : std::nullopt;
}

std::optional<std::string> Catalogue::fromParts(std::string_view english, Search search) const {
    for (const std::string_view separator : {"\n", "  ·  ", " · ", ". "}) {
        if (std::optional<std::string> text = joined(english, separator, search))
            return text;
    }
    if (english.ends_with('.')) {
        if (std::optional<std::string> text = lookUp(english.substr(0, english.size() - 1), search.deeper()))
            return *text + (language_ == Language::Chinese ? "。" : ".");
    }
    // "Triangle 12"
    if (const std::size_t last = english.find_last_not_of("0123456789");
        last != std::string_view::npos && last + 1 < english.size() && english[last] == ' ') {
        if (std::optional<std::string> text = lookUp(english.substr(0, last), search.deeper()))
            return *text + std::string(english.substr(last));
    }
    for (const std::string_view separator : {": ", ", "}) {
        if (std::optional<std::string> text = joined(english, separator, search))
            return text;
    }
    return std::nullopt;
}

} // namespace texplorer::ui

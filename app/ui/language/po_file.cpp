#include "app/ui/language/po_file.h"

#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace texplorer::ui {
namespace {

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

/// The placeholders of a text: "0" and "1" of "{0} × {1:.2f}". Doubled braces are none.
std::set<std::string_view> placesOf(std::string_view text) {
    std::set<std::string_view> places;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '{')
            continue;
        const std::string_view place = text.substr(i + 1, text.find('}', i) - i - 1);
        if (!place.starts_with('{'))
            places.insert(place.substr(0, place.find(':')));
        i += place.starts_with('{') ? 1 : place.size();
    }
    return places;
}

/// Fails for a translation whose placeholders are not those of its text.
Result<void> checkPlaces(const PoEntry& entry, std::string_view name) {
    const std::set<std::string_view> expected = placesOf(entry.key);
    for (const std::string& form : entry.forms) {
        std::vector<std::string_view> others;
        std::ranges::set_symmetric_difference(expected, placesOf(form), std::back_inserter(others));
        if (others.empty())
            continue;
        const std::string place = '{' + printable(others.front().substr(0, 40)) + '}';
        return fail(ErrorCode::Malformed,
                    expected.contains(others.front())
                        ? Sentence("expected a translation with {0}, as in its text", ProperName{place})
                        : Sentence("expected a translation without {0}, as in its text", ProperName{place}),
                    inFile(std::string(name)) / atLine(entry.line));
    }
    return {};
}

std::string inPoQuotes(std::string_view text) {
    std::string quoted;
    for (const char each : text) {
        if (each == '"' || each == '\\' || each == '\n' || each == '\t')
            quoted += '\\';
        quoted += each == '\n' ? 'n' : each == '\t' ? 't' : each;
    }
    return '"' + quoted + '"';
}

} // namespace

bool PoEntry::isTranslated() const {
    return !isFuzzy && !forms.empty() && std::ranges::none_of(forms, &std::string::empty);
}

Result<std::vector<PoEntry>> readPoFile(std::string_view text, std::string_view name) {
    std::vector<PoEntry> entries;
    bool isFuzzy = false;        // the comment stands before its entry
    std::string* last = nullptr; // continued by a line of text alone
    std::size_t number = 0;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string_view line = text.substr(from, end - from);
        from = end + 1;
        ++number;
        if (line.empty() || line.starts_with("#")) {
            last = nullptr;
            isFuzzy |= line.starts_with("#,") && line.find("fuzzy") != std::string_view::npos;
            continue;
        }
        const std::string_view word = line.substr(0, line.find_first_of(" [\""));
        std::optional<std::string> words = quoted(line);
        if (words && word == "msgid") {
            entries.push_back({.key = {}, .pluralKey = {}, .forms = {}, .isFuzzy = isFuzzy, .line = number});
            isFuzzy = false;
            last = &entries.back().key;
        } else if (words && word == "msgid_plural" && last) {
            last = &entries.back().pluralKey;
        } else if (words && word == "msgstr" && last) {
            last = &entries.back().forms.emplace_back();
        } else if (!words || !word.empty() || !last) {
            return fail(ErrorCode::Malformed, "expected a line of a .po file, msgid or msgstr with its text",
                        inFile(std::string(name)) / atLine(number));
        }
        *last += *words;
    }
    for (const PoEntry& entry : entries) {
        if (entry.key.empty() || !entry.isTranslated())
            continue;
        if (const Result<void> checked = checkPlaces(entry, name); !checked)
            return fail(checked.error());
    }
    return entries;
}

std::string poTemplate(std::span<const std::string> texts, std::string_view source) {
    std::string written = "msgid \"\"\nmsgstr \"\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n";
    std::set<std::string_view> known{""};
    for (const std::string& text : texts) {
        if (!known.insert(text).second)
            continue;
        // gettext's tools compare the placeholders, "{color}", of a text and its translation.
        const std::string_view flag = text.find('{') == std::string::npos ? "" : "#, python-brace-format\n";
        written += fmt::format("\n#: {}\n{}msgid {}\nmsgstr \"\"\n", source, flag, inPoQuotes(text));
    }
    return written;
}

} // namespace texplorer::ui

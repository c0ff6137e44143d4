#pragma once

#include "texplorer/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// An entry of a gettext .po file.
struct PoEntry {
    std::string key;                ///< msgid
    std::string pluralKey;          ///< msgid_plural; empty: none
    std::vector<std::string> forms; ///< msgstr, one for each plural form
    bool isFuzzy = false;
    std::size_t line = 0; ///< of msgid, from 1

    [[nodiscard]] bool isTranslated() const;
};

/// Reads the entries of a .po file, the header's included. `name` is the file's for errors. Fails for a line
/// that is no comment and no part of an entry, and for a translation whose placeholders, "{0}", are not those
/// of its text.
[[nodiscard]] Result<std::vector<PoEntry>> readPoFile(std::string_view text, std::string_view name);

/// Writes a template for translators, a .pot file: an empty entry for each text, in order and each once.
/// `source` is the file's that has the texts. Texts are without a NUL.
[[nodiscard]] std::string poTemplate(std::span<const std::string> texts, std::string_view source);

} // namespace texplorer::ui

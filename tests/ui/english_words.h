#pragma once

#include <string>
#include <string_view>

namespace texplorer::test {

/// The English words of a translated text, with commas between them: those of three Latin letters or more,
/// but for what is the same in every language: OpenGL's names, paths of parameters, formulas, units, formats,
/// keys.
[[nodiscard]] std::string englishWords(std::string_view text);

} // namespace texplorer::test

#include "tests/ui/english_words.h"

#include <regex>

namespace texplorer::test {
namespace {

const std::regex latinWord("[A-Za-z][A-Za-z0-9]{2,}");
/// A title; a name of OpenGL, of a parameter or of a file, a call; what is quoted.
const std::regex codeWord(R"(OpenGL Programming Guide|"[^"]*"|'[^']*'|[^ ]*(_|\[|::|[A-Za-z0-9]\.[A-Za-z]|/|[a-z]\()[^ ]*)");
/// Abbreviations; names of other programs' fields and functions, with a capital within; numbers.
const std::regex
    nameWord("[A-Z0-9]+|[A-Za-z]*[a-z][A-Z][A-Za-z0-9]*|[A-Z]{2,}[a-z]?[A-Z]*|[xu][0-9a-f]+|Arg[012]");
const std::regex sameEverywhere(
    "RGBA?[0-9]*|OpenGL|glpng|OSMesa|Mesa|GLUquadric|glad|Texplorer|texshot|[Ll]lvmpipe|softpipe|Direct|DirectX|Adam7|Exif|"
    "Adobe|Huffman|Catmull|Rom|Mitchell|Netravali|Newell|NeHe|Phong|Gouraud|Kaiser|Lanczos|Paeth|"
    "[Mm]ip|[Mm]ipmaps?|[Aa]lpha|[Gg]amma|[Rr]ho|[Ll]ambda|Enter|Tab|Del|Home|End|Insert|Page|Shift|Ctrl|Alt|Esc|"
    "KiB|MiB|cos|sin|sqrt|floor|frac|clamp|max|min|abs|dot|vec[234]|mat4|float|shadow|acne|true|false|null|e[0-9]+");

} // namespace

std::string englishWords(std::string_view text) {
    const std::string plain = std::regex_replace(std::string(text), codeWord, " ");
    std::string words;
    for (std::sregex_iterator match(plain.begin(), plain.end(), latinWord), end; match != end; ++match) {
        const std::string found = match->str();
        if (!std::regex_match(found, nameWord) && !std::regex_match(found, sameEverywhere))
            words += (words.empty() ? "" : ", ") + found;
    }
    return words;
}

} // namespace texplorer::test

#include "texplorer/emit/js_functions.h"

#include "texplorer/emit/piece_files.h"

#include <cctype>

namespace texplorer::emit {
namespace {

/// What a file declares: "set_normal_matrix.js" has setNormalMatrix.
std::string nameIn(std::string_view file) {
    std::string name;
    for (std::size_t i = 0; i < file.find('.'); ++i) {
        if (file[i] == '_')
            name += static_cast<char>(std::toupper(static_cast<unsigned char>(file[++i])));
        else
            name += file[i];
    }
    return name;
}

bool isOfName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Whether a text has the word; no other name ends or begins with the same letters.
bool uses(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !(isOfName(text[at - 1]) || text[at - 1] == '.');
        if (begins && (end == text.size() || !isOfName(text[end]) || word.ends_with('(')))
            return true;
    }
    return false;
}

} // namespace

std::string jsFunctionsFor(std::string_view text) {
    std::string all;
    const std::vector<PieceFile>& files = scriptFunctionFiles();
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
        std::string word = nameIn(file->name);
        if (file->text.find("function " + word + "(") != std::string::npos)
            word += '('; // a call, and no word of a comment
        if (uses(text, word) || uses(all, word))
            all = file->text + "\n" + all;
    }
    return all;
}

} // namespace texplorer::emit

#include "core/emit/js_functions.h"

#include "core/emit/piece_files.h"

#include <cctype>

namespace texplorer::emit {
namespace {

/// "set_normal_matrix.js" has setNormalMatrix().
std::string functionOf(std::string_view file) {
    std::string name;
    for (std::size_t i = 0; i < file.find('.'); ++i) {
        if (file[i] == '_')
            name += static_cast<char>(std::toupper(static_cast<unsigned char>(file[++i])));
        else
            name += file[i];
    }
    return name;
}

/// Whether a text calls it: no other name ends with the same letters.
bool calls(std::string_view text, std::string_view name) {
    const std::string call = std::string(name) + "(";
    for (std::size_t at = text.find(call); at != std::string_view::npos; at = text.find(call, at + 1)) {
        const char before = at == 0 ? ' ' : text[at - 1];
        const bool isName =
            (before >= 'a' && before <= 'z') || (before >= 'A' && before <= 'Z') || before == '.';
        if (!isName)
            return true;
    }
    return false;
}

} // namespace

std::string jsFunctionsFor(std::string_view text) {
    std::string all;
    const std::vector<PieceFile>& files = scriptFunctionFiles();
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
        const std::string name = functionOf(file->name);
        if (calls(text, name) || calls(all, name))
            all = file->text + "\n" + all;
    }
    return all;
}

} // namespace texplorer::emit

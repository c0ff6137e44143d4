#include "texplorer/glsl/source_writer.h"

#include "texplorer/base/sentence_format.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer::glsl {

namespace {

std::string substituted(std::string line, const std::vector<Substitution>& substitutions) {
    for (const auto& [word, text] : substitutions) {
        for (std::size_t at = line.find(word); at != std::string::npos;
             at = line.find(word, at + text.size()))
            line.replace(at, word.size(), text);
    }
    return line;
}

} // namespace

void SourceWriter::add(std::string_view file, const std::string& name,
                       const std::vector<Substitution>& substitutions) {
    const std::string fileName = std::string(file) + ".glsl";
    const ShaderPiece* piece = pieces_.find(fileName, name);
    if (!piece) {
        if (!error_)
            error_ = Error{ErrorCode::NotFound, Sentence("the piece \"{0}\" is missing", ProperName{name}),
                           inFile(fileName)};
        return;
    }
    int line = piece->firstLine;
    for (const std::string& text : piece->lines) {
        source_.text += substituted(text, substitutions) + '\n';
        source_.lines.push_back({fileName, line++});
    }
}

void SourceWriter::append(SourceWriter&& other) {
    source_.text += other.source_.text;
    std::ranges::move(other.source_.lines, std::back_inserter(source_.lines));
    if (!error_)
        error_ = std::move(other.error_);
}

Result<StageSource> SourceWriter::finish() && {
    if (error_)
        return fail(std::move(*error_));
    return std::move(source_);
}

} // namespace texplorer::glsl

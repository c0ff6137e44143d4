#pragma once

#include "texplorer/base/sentence.h"

#include <functional>
#include <vector>

namespace texplorer::render {

/// Calls glGetError, without a GL header.
[[nodiscard]] unsigned currentGlError();

/// Collects errors of drawing as sentences, each once.
class GlErrors {
public:
    /// Collects the GL errors since the last check. `where` names the call or the group of calls:
    /// "textures[0]: glTexImage2D" gives "textures[0]: glTexImage2D: GL_INVALID_VALUE (A number is out of
    /// range.)". Returns true if there was no error. Returns even if a driver reports errors for ever.
    bool check(const Sentence& where, unsigned (*getError)() = currentGlError);
    /// The same, but computes the name only if there was an error.
    bool check(const std::function<Sentence()>& where, unsigned (*getError)() = currentGlError);

    void add(Sentence sentence);
    void add(const std::vector<Sentence>& sentences);

    [[nodiscard]] const std::vector<Sentence>& sentences() const { return sentences_; }

private:
    std::vector<Sentence> sentences_;
};

} // namespace texplorer::render

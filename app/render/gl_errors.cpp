#include "app/render/gl_errors.h"

#include "texplorer/gl/error.h"

#include <GL/glew.h>

#include <algorithm>

namespace texplorer::render {

namespace {

// GL holds one flag per kind of error (section 2.5), distributed implementations several. Without a context,
// or with a lost one, glGetError may return errors for ever.
constexpr int maxFlags = 16;

Sentence nameOf(unsigned error) {
    if (const EnumRow* found = findRow(glErrorRows, error))
        return Sentence("{0} ({1})", ProperName{found->name}, found->help);
    return Sentence("error {0}", error);
}

/// What follows "textures[0]: " stays one sentence.
Sentence placed(const Sentence& where, const Sentence& what) {
    return where.key() == "{0}: {1}"
               ? Sentence("{0}: {1}", where.arguments()[0], placed(where.arguments()[1], what))
               : Sentence("{0}: {1}", where, what);
}

} // namespace

unsigned currentGlError() {
    return glGetError();
}

bool GlErrors::check(const Sentence& where, unsigned (*getError)()) {
    return check([&] { return where; }, getError);
}

bool GlErrors::check(const std::function<Sentence()>& where, unsigned (*getError)()) {
    bool clean = true;
    for (int flag = 0; flag < maxFlags; ++flag) {
        const unsigned error = getError();
        if (error == GL_NO_ERROR)
            break;
        clean = false;
        add(placed(where(), nameOf(error)));
        if (error == static_cast<unsigned>(GlError::ContextLost))
            break;
    }
    return clean;
}

void GlErrors::add(Sentence sentence) {
    if (std::ranges::find(sentences_, sentence) == sentences_.end())
        sentences_.push_back(std::move(sentence));
}

void GlErrors::add(const std::vector<Sentence>& sentences) {
    for (const Sentence& sentence : sentences)
        add(sentence);
}

} // namespace texplorer::render

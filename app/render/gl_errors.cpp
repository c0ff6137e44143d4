#include "app/render/gl_errors.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/gl/error.h"

#include <GL/glew.h>
#include <fmt/core.h>

#include <algorithm>

namespace texplorer::render {

namespace {

// GL holds one flag per kind of error (section 2.5), distributed implementations several. Without a context,
// or with a lost one, glGetError may return errors for ever.
constexpr int maxFlags = 16;

std::string nameOf(unsigned error) {
    if (const EnumRow* found = findRow(glErrorRows, error))
        return fmt::format("{} ({})", found->name, found->help);
    return fmt::format("error {}", error);
}

} // namespace

unsigned currentGlError() {
    return glGetError();
}

bool GlErrors::check(std::string_view where, unsigned (*getError)()) {
    return check([&] { return std::string(where); }, getError);
}

bool GlErrors::check(const std::function<std::string()>& where, unsigned (*getError)()) {
    bool clean = true;
    for (int flag = 0; flag < maxFlags; ++flag) {
        const unsigned error = getError();
        if (error == GL_NO_ERROR)
            break;
        clean = false;
        add(fmt::format("{}: {}", where(), nameOf(error)));
        if (error == static_cast<unsigned>(GlError::ContextLost))
            break;
    }
    return clean;
}

void GlErrors::add(std::string sentence) {
    if (std::ranges::find(sentences_, sentence) == sentences_.end())
        sentences_.push_back(std::move(sentence));
}

void GlErrors::add(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences)
        add(sentence);
}

} // namespace texplorer::render

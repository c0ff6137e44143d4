#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::render {

/// glGetError, without a GL header.
[[nodiscard]] unsigned currentGlError();

/// Collects what goes wrong while something is drawn, as sentences; each is kept once.
class GlErrors {
public:
    /// Asks GL for the errors since the last check. `where` names the call or group of calls in between:
    /// "textures[0]: glTexImage2D" gives "textures[0]: glTexImage2D: GL_INVALID_VALUE (A number is out of
    /// range.)". True where there was none. Ends even where a driver reports an error for ever.
    bool check(std::string_view where, unsigned (*getError)() = currentGlError);
    /// The same; the name is asked for where there was an error.
    bool check(const std::function<std::string()>& where, unsigned (*getError)() = currentGlError);

    void add(std::string sentence);
    void add(const std::vector<std::string>& sentences);

    [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::vector<std::string> sentences_;
};

} // namespace texplorer::render

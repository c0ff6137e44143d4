#include "texplorer/emit/program_frame.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace texplorer::emit {
namespace {

constexpr std::size_t commentColumns = 100;

/// Letters, digits and a few others mean themselves to a shell.
bool isPlainLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// What a comment can't show as it is becomes an underscore.
std::string fileName(const std::string& name) {
    if (name.empty())
        return "demo.c";
    if (inComment(name) == name)
        return name;
    std::string text = name;
    std::ranges::replace_if(
        text, [](char c) { return !isPlainLetter(c); }, '_');
    return text;
}

/// As a shell has it, and no option of the compiler.
std::string fileWord(const std::string& name) {
    return shellWord(name.starts_with('-') ? "./" + name : name);
}

/// What a loader needs of the frame.
struct LoaderCode {
    std::string_view headers;   ///< "": those of every program
    std::string_view compiled;  ///< files and options of the compiler
    std::string_view library;   ///< before those of OpenGL
    std::string_view condition; ///< under which it can't load; "": it doesn't
};

/// In the order of Loader.
constexpr std::array loaderCodes{
    LoaderCode{},
    LoaderCode{"#include <GL/glew.h> /* functions of OpenGL after 1.1; before other headers of OpenGL */\n",
               "", " -lGLEW", "loaded != GLEW_OK && loaded != GLEW_ERROR_NO_GLX_DISPLAY /* on Wayland */"},
    LoaderCode{"#include <glad/gl.h> /* glad --api gl:compatibility --out-path glad c */\n",
               " glad/src/gl.c -Iglad/include", "", "!gladLoadGL(glfwGetProcAddress)"},
};

const LoaderCode& codeOf(Loader loader) {
    return loaderCodes.at(static_cast<std::size_t>(loader));
}

bool callsGlu(const std::vector<Line>& lines) {
    return std::ranges::any_of(lines, [](const Line& line) {
        return std::ranges::any_of(line.parts, [](const Part& part) {
            return part.kind == Part::Kind::Call && part.text.starts_with("glu");
        });
    });
}

constexpr std::string_view ending = ".c";

bool isNamedAsC(const std::string& file) {
    return file.size() > ending.size() && file.ends_with(ending);
}

/// What compiles the file, into one of its name without an ending.
std::string compilerLine(const std::string& file, const LoaderCode& loader, bool glu) {
    const std::string libraries = fmt::format("-lglfw{}{} -lGL -lm", loader.library, glu ? " -lGLU" : "");
    if (isNamedAsC(file))
        return fmt::format("cc {}{} -o {} {}", fileWord(file), loader.compiled,
                           fileWord(file.substr(0, file.size() - ending.size())), libraries);
    return fmt::format("cc -x c {} -x none{} -o {} {}", fileWord(file), loader.compiled,
                       fileWord(file + ".out"), libraries);
}

/// The headers of GLFW and OpenGL.
std::string headerLines(const LoaderCode& loader, bool glu) {
    std::string text(loader.headers.empty() ? openGlHeaders() : loader.headers);
    if (!loader.headers.empty())
        text += "#include <GLFW/glfw3.h>\n";
    if (glu)
        text.insert(text.rfind("#include"), "#define GLFW_INCLUDE_GLU\n");
    return text;
}

/// "/*" and lines of words that begin with " * ". The last paragraph is one line, however long it is.
void addComment(std::vector<Line>& lines, const std::vector<std::string>& paragraphs) {
    std::string text;
    for (const std::string& paragraph : paragraphs) {
        std::string rest = inComment(paragraph);
        const bool isBroken = &paragraph != &paragraphs.back();
        do {
            std::size_t cut = rest.size();
            if (isBroken && rest.size() > commentColumns)
                cut = std::min(rest.rfind(' ', commentColumns), rest.size());
            text += (text.empty() ? "/* " : " * ") + rest.substr(0, cut) + "\n";
            rest.erase(0, std::min(cut + 1, rest.size()));
        } while (!rest.empty());
    }
    text.insert(text.size() - 1, " */");
    for (Line& line : linesOf(text))
        lines.push_back(std::move(line));
}

constexpr std::string_view mouse = R"(/* Dragging turns the view, the wheel goes nearer. */
static void onMove(GLFWwindow *window, double x, double y)
{
    static double lastX, lastY;
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
        azimuth -= (GLfloat)(x - lastX) / 2;
        elevation += (GLfloat)(y - lastY) / 2;
    }
    lastX = x;
    lastY = y;
}

static void onScroll(GLFWwindow *window, double x, double y)
{
    (void)window;
    (void)x;
    distance *= powf(0.9f, (GLfloat)y);
}
)";

/// A word on how key frames begin again, which they don't by themselves.
std::string repetition(const KeyFrames& keys) {
    float last = 0;
    for (const auto& [path, param] : keys.params())
        if (param.isUsed)
            last = std::max(last, param.keys.back().seconds);
    return last > 0 ? fmt::format(" /* fmod(glfwGetTime(), {}): again and again */", formatNumber(last))
                    : std::string();
}

std::string mainFunction(const Emission& emission, const CProgram& program) {
    std::string hints;
    for (const std::string& hint : program.hints)
        hints += fmt::format("    glfwWindowHint({});\n", hint);
    const bool moves = emission.moves;
    std::string loading;
    if (const LoaderCode& loader = codeOf(emission.options.loader); !loader.condition.empty())
        loading = fmt::format("{}    if ({}) {{\n"
                              "        fputs(\"the functions of OpenGL can't be loaded\\n\", stderr);\n"
                              "        glfwTerminate();\n"
                              "        return EXIT_FAILURE;\n"
                              "    }}\n",
                              emission.options.loader == Loader::Glew
                                  ? "    glewExperimental = GL_TRUE; /* of the core profile, too */\n"
                                    "    const GLenum loaded = glewInit();\n"
                                  : "",
                              loader.condition);
    return fmt::format(R"(
int main(void)
{{
    if (!glfwInit()) {{
        fputs("GLFW can't be initialised\n", stderr);
        return EXIT_FAILURE;
    }}
{}    GLFWwindow *window = glfwCreateWindow({}, {}, {}, NULL, NULL);
    if (!window) {{
        fputs("there is no window with OpenGL\n", stderr);
        glfwTerminate();
        return EXIT_FAILURE;
    }}
    glfwMakeContextCurrent(window);
{}    glfwSwapInterval(1); /* a frame for each picture of the screen */
    glfwSetCursorPosCallback(window, onMove);
    glfwSetScrollCallback(window, onScroll);
    init();
    while (!glfwWindowShouldClose(window)) {{
        int width, height;
        glfwGetFramebufferSize(window, &width, &height);
        if (height > 0)
            draw(width, height{});{}
        glfwSwapBuffers(window);
        {}
    }}
    glfwTerminate();
    return EXIT_SUCCESS;
}}
)",
                       hints, emission.options.width, emission.options.height,
                       stringLiteral(emission.options.title), loading, moves ? ", glfwGetTime()" : "",
                       repetition(emission.keys),
                       moves ? "glfwPollEvents();" : "glfwWaitEvents(); /* nothing moves by itself */");
}

void append(std::vector<Line>& lines, std::vector<Line> more) {
    std::ranges::move(more, std::back_inserter(lines));
}

} // namespace

std::vector<Line> framed(Emission&& emission, const CProgram& program) {
    const ProgramOptions& options = emission.options;
    std::vector<Line> lines;
    const std::string file = fileName(options.source);
    const LoaderCode& loader = codeOf(options.loader);
    std::vector<Line> written = std::move(emission.writer).take();
    const bool glu = callsGlu(written);
    std::vector<std::string> about{options.title, compilerLine(file, loader, glu)};
    if (!options.about.empty())
        about.insert(about.begin() + 1, options.about);
    addComment(lines, about);
    append(lines, linesOf(headerLines(loader, glu)));
    std::set<std::string_view> headers = headersOf(emission.functions);
    headers.insert({"math.h", "stdio.h", "stdlib.h"}); // of the frame itself
    headers.insert(program.headers.begin(), program.headers.end());
    for (const std::string_view header : headers)
        append(lines, linesOf(fmt::format("#include <{}>\n", header)));
    append(lines, linesOf("\n"));
    if (emission.functions.erase(CFunction::MeshTypes) > 0) {
        append(lines, linesOf({CFunction::MeshTypes}));
        append(lines, linesOf("\n"));
    }
    append(lines, std::move(emission.atStart).take());
    append(lines, linesOf(emission.functions));
    append(lines, std::move(written));
    append(lines, linesOf(mouse));
    append(lines, linesOf(mainFunction(emission, program)));
    append(lines, std::move(emission.atEnd).take());
    finish(lines);
    return lines;
}

std::string cmakeLists(const std::vector<Line>& program, const ProgramOptions& options) {
    const bool isGlad = options.loader == Loader::Glad;
    const bool isGlew = options.loader == Loader::Glew;
    const std::string name = options.source.substr(0, options.source.find('.'));
    // The target has a name of its own: that of the file may be one that CMake has.
    return fmt::format(
        "cmake_minimum_required(VERSION 3.16)\n"
        "project(program C)\n"
        "set(CMAKE_C_STANDARD 99)\n"
        "find_package(glfw3 REQUIRED)\n"
        "find_package(OpenGL REQUIRED)\n"
        "{}add_executable(program {}{})\n"
        "set_target_properties(program PROPERTIES OUTPUT_NAME {})\n"
        "{}target_link_libraries(program PRIVATE glfw{}{} OpenGL::GL $<$<BOOL:${{UNIX}}>:m>)\n",
        isGlew ? "find_package(GLEW REQUIRED)\n" : "", options.source, isGlad ? " glad/src/gl.c" : "", name,
        isGlad ? "target_include_directories(program PRIVATE glad/include)\n" : "",
        isGlew ? " GLEW::GLEW" : "", callsGlu(program) ? " OpenGL::GLU" : "");
}

} // namespace texplorer::emit

#include "app/screenshot/reports/step_programs.h"

#include "app/screenshot/reports/program_text.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/excerpt.h"
#include "texplorer/emit/flavour.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace texplorer::screenshot {
namespace {

using Paths = std::set<std::string, std::less<>>;

constexpr std::size_t maxExcerptLines = 12;
constexpr std::size_t maxNewCalls = 20; // of an answer
/// Of a photograph the texels alone would be tens of megabytes.
constexpr std::size_t maxProgramBytes = std::size_t{4} << 20;

std::string codeHtml(const emit::Line& line) {
    std::string html;
    for (const emit::Part& part : line.parts)
        html += part.kind == emit::Part::Kind::Comment ? fmt::format("<i>{}</i>", htmlOf(part.text))
                                                       : htmlOf(part.text);
    return html + "\n";
}

/// The word on what a call does, in the page's language.
emit::Line translated(emit::Line line, const PageWords& words) {
    constexpr std::string_view begin = "/* ";
    constexpr std::string_view end = " */";
    for (emit::Part& part : line.parts) {
        const std::string_view text = part.text;
        if (!line.heading && part.kind == emit::Part::Kind::Comment && text.starts_with(begin) &&
            text.ends_with(end))
            part.text = fmt::format(
                "{}{}{}", begin,
                words.word(text.substr(begin.size(), text.size() - begin.size() - end.size())), end);
    }
    return line;
}

std::string excerptHtml(const PageWords& words, const emit::Excerpt& excerpt) {
    if (excerpt.lines.empty())
        return {};
    std::string code;
    for (const emit::Line& line : excerpt.lines)
        code += fmt::format("<span>{}</span>", codeHtml(translated(line, words)));
    if (excerpt.left > 0)
        code += fmt::format("<span><i>/* {} */</i>\n</span>",
                            words.wordHtml(Sentence("and {0} more lines", excerpt.left)));
    return fmt::format("<div class=\"excerpt\"><p class=\"source\">{}</p><pre><code>{}</code></pre></div>\n",
                       words.wordHtml("Where the program sets it:"), code);
}

/// All of it but the numbers of long arrays. What the step is about is marked.
std::string wholeHtml(const PageWords& words, const std::vector<emit::Line>& program, const Paths& paths) {
    const std::vector<emit::Line> lines = shownLines(program, false);
    std::string code;
    for (const emit::Line& line : lines) {
        const std::string html = codeHtml(line);
        code +=
            isAbout(line, paths) ? fmt::format("<mark>{}</mark>\n", html.substr(0, html.size() - 1)) : html;
    }
    return fmt::format(
        "<details class=\"whole\"><summary>{}</summary><pre tabindex=\"0\"><code>{}</code></pre></details>\n",
        words.wordHtml(Sentence("The whole program, {0} lines", lines.size())), code);
}

/// Where no call sets what a step is about, but it decides on a texture's texels: what hands these to OpenGL.
Paths uploadsOf(const Paths& subjects) {
    Paths paths;
    for (const std::string& each : subjects) {
        const std::size_t end = each.find("].");
        if (!each.starts_with(keyOf<&Scene::textures>()) || end == std::string::npos)
            continue;
        for (const std::string& key : {keyOf<&Texture::internalFormat>(), keyOf<&Texture::compressedFormat>(),
                                       keyOf<&Texture::file>()})
            paths.insert(each.substr(0, end + 2) + key);
    }
    return paths;
}

/// The fixed-function program of the step before, where both are of one scene: what is new shows itself then.
std::vector<emit::Line> programBefore(const PageLesson& lesson, std::size_t index) {
    if (index == 0 || !lesson.lesson.steps[index].scene.empty())
        return {};
    emit::TextureCodes codes;
    return startOf(lesson.folder, lesson.lesson, index - 1)
        .and_then([&](const lesson::LessonScene& scene) {
            return programOfStep(lesson.lesson, index - 1, scene, emit::Flavour::Fixed, "before.c", codes);
        })
        .map([](ProgramText&& program) { return std::move(program.lines); })
        .value_or(std::vector<emit::Line>{});
}

emit::Excerpt excerptOfStep(const PageLesson& lesson, std::size_t index,
                            const std::vector<emit::Line>& program) {
    const Paths subjects = subjectsOf(lesson.lesson.steps[index]);
    for (const Paths& paths : {subjects, uploadsOf(subjects)}) {
        emit::Excerpt excerpt = excerptOf(program, paths, maxExcerptLines);
        if (!excerpt.lines.empty())
            return excerpt;
    }
    return newIn(program, programBefore(lesson, index), maxExcerptLines);
}

std::string fileOf(emit::Flavour flavour, const std::string& place) {
    return fmt::format("{}{}.c", place, flavour == emit::Flavour::Glsl ? "-glsl" : "");
}

/// The programs of a step, one after the other.
class ProgramsWriter {
public:
    ProgramsWriter(const PageLesson& lesson, std::size_t index, const lesson::LessonScene& scene,
                   const std::string& place)
        : lesson_(lesson)
        , index_(index)
        , scene_(scene)
        , place_(place) {}

    Result<StepPrograms> write() {
        std::string names;
        for (const EnumRow& row : emit::flavourRows) {
            const auto flavour = static_cast<emit::Flavour>(row.value);
            const std::string name = fileOf(flavour, place_);
            Result<ProgramText> program =
                programOfStep(lesson_.lesson, index_, scene_, flavour, name, codes_);
            if (!program && program.error().code != ErrorCode::Unsupported)
                return fail(program.error());
            names += fmt::format("<li>{}</li>\n", program ? add(row, name, *program)
                                                          : refusal(row, describe(program.error())));
        }
        out_.whole = shown_ + fmt::format("<ul class=\"files\">\n{}</ul>\n", names);
        return std::move(out_);
    }

private:
    [[nodiscard]] const PageWords& words() const { return lesson_.words; }

    [[nodiscard]] std::string refusal(const EnumRow& row, const Sentence& sentence) const {
        return fmt::format("{}: {}", words().wordHtml(row.label), words().wordHtml(sentence));
    }

    std::string add(const EnumRow& row, const std::string& name, const ProgramText& program) {
        const std::string text = textOf(program.lines, false);
        if (row.value == static_cast<std::uint32_t>(emit::Flavour::Fixed)) {
            const Paths paths = subjectsOf(lesson_.lesson.steps[index_]);
            out_.excerpt = excerptHtml(words(), excerptOfStep(lesson_, index_, program.lines));
            shown_ = wholeHtml(words(), program.lines, paths);
        }
        if (text.size() > maxProgramBytes)
            return refusal(row, Sentence("the program contains {0} MB of texels; \"texshot emit\" writes it",
                                         text.size() >> 20));
        const std::string folder = fmt::format("programs/{}/", lesson_.anchor);
        const ByteView bytes = viewBytes(text);
        out_.files.push_back({folder + name, Bytes(bytes.begin(), bytes.end())});
        std::string with;
        for (const ReadFile& each : program.files) {
            out_.files.push_back({folder + each.name, each.bytes});
            with += (with.empty() ? "" : ", ") + each.name;
        }
        const std::string reads =
            with.empty() ? "" : ", " + words().wordHtml(Sentence("which reads {0}", ProperName{with}));
        return fmt::format("<a href=\"{0}{1}\">{1}</a> <b>{2}{3}</b>", folder, name,
                           words().wordHtml(row.label), reads);
    }

    const PageLesson& lesson_;
    std::size_t index_;
    const lesson::LessonScene& scene_;
    const std::string& place_;
    emit::TextureCodes codes_;
    std::string shown_; ///< the program that stands on the page
    StepPrograms out_;
};

} // namespace

std::string newCallsHtml(const PageLesson& lesson, std::size_t index, const lesson::LessonScene& before,
                         const lesson::LessonScene& after) {
    emit::TextureCodes codes;
    const auto linesOf = [&](const lesson::LessonScene& scene) {
        return programOfStep(lesson.lesson, index, scene, emit::Flavour::Fixed, "demo.c", codes)
            .map([](ProgramText&& program) { return std::move(program.lines); })
            .value_or(std::vector<emit::Line>{});
    };
    const auto isCode = [](const emit::Part& part) {
        return part.kind != emit::Part::Kind::Comment &&
               part.text.find_first_not_of(' ') != std::string::npos;
    };
    const emit::Excerpt excerpt = newIn(linesOf(after), linesOf(before), maxNewCalls);
    std::string html;
    for (const emit::Line& line : excerpt.lines)
        if (!line.heading && std::ranges::any_of(line.parts, isCode))
            html += fmt::format("<code>{}</code><br>", codeHtml(line));
    if (excerpt.left > 0)
        html += lesson.words.wordHtml(Sentence("and {0} more lines", excerpt.left)) + "<br>";
    return html;
}

Result<StepPrograms> stepPrograms(const PageLesson& lesson, std::size_t index,
                                  const lesson::LessonScene& scene, const std::string& place) {
    return ProgramsWriter(lesson, index, scene, place).write();
}

} // namespace texplorer::screenshot

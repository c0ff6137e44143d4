// A scene as a program.

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/reports/program_text.h"
#include "app/view/pretence.h"
#include "texplorer/files/file_io.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>

namespace texplorer::screenshot {
namespace {

struct EmitOptions {
    SceneArgument scene;
    std::vector<std::string> pretended;
    std::string out = "-";
    std::string flavour{rowOf(emit::Flavour::Fixed).name};
    std::string loader{rowOf(emit::Loader::Prototypes).name};
    bool files = false;
    bool selfContained = false;
    bool cmake = false;
};

/// Whether CMake reads the file's name as it is. The error names an option.
Result<void> checkCMakeName(const std::string& out) {
    const std::filesystem::path file = std::filesystem::path(out).filename();
    const std::string stem = file.stem().string();
    const auto isPlain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    };
    if (file.extension() == ".c" && !stem.starts_with('-') && std::ranges::all_of(stem, isPlain))
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("expected letters, digits, _ or - and .c, as CMake reads the name, found \"{0}\"",
                         file.string()),
                atOption("--out"));
}

/// Whether other files can be written next to the program. The error names an option.
Result<void> checkFilesBeside(const EmitOptions& options) {
    if (!options.files && !options.cmake)
        return {};
    if (options.files && options.scene.lesson.empty())
        return fail(ErrorCode::OutOfRange, "only the files of a lesson are written next to a program",
                    atOption("--files"));
    if (isStandardOutput(options.out))
        return fail(ErrorCode::OutOfRange, "expected a file name, to write other files next to it",
                    atOption("--out"));
    if (const Result<void> named = options.cmake ? checkCMakeName(options.out) : Result<void>(); !named)
        return named;
    std::error_code ignored;
    const std::filesystem::file_status there = std::filesystem::status(options.out, ignored);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a file, to write other files next to it, found \"{0}\"", options.out),
                    atOption("--out"));
    return {};
}

/// The program with the files next to it, all or none. Those that are there already stay, if they are what
/// they should be.
Result<void> writeBeside(const std::string& program, const Output& out, const std::string& text,
                         const std::vector<ReadFile>& files) {
    const std::filesystem::path folder = std::filesystem::path(program).parent_path();
    std::vector<FileContent> missing;
    for (const ReadFile& each : files) {
        const std::filesystem::path place = folder / each.name;
        std::error_code ignored;
        if (place == std::filesystem::path(program) ||
            equivalent(place, std::filesystem::path(program), ignored))
            return fail(ErrorCode::Unwritable, "is the name of a file to write next to the program",
                        inFile(program));
        const Result<Bytes> there = readFile(place, each.bytes.size());
        if (!there && there.error().code == ErrorCode::NotFound)
            missing.push_back({each.name, each.bytes});
        else if (!there && there.error().code != ErrorCode::TooLarge)
            return fail(there.error());
        else if (!there || *there != each.bytes)
            return fail(
                ErrorCode::Unwritable,
                "is there already, and is not the file to write next to the program: choose another folder",
                inFile(place.string()));
    }
    if (!missing.empty()) {
        std::optional<Uninterrupted> placing;
        if (Result<void> placed = writeFolderAtomically(folder.empty() ? "." : folder, missing,
                                                        [&placing] { placing.emplace(); });
            !placed)
            return placed;
    }
    Result<void> written = out.write(viewBytes(text));
    std::error_code ignored;
    for (const FileContent& each : missing)
        if (!written)
            std::filesystem::remove(folder / each.name, ignored);
    return written;
}

ExitCode emitProgram(const EmitOptions& options) {
    const Result<emit::Flavour> flavour = parseChoice<emit::Flavour>(options.flavour, "--as");
    if (!flavour)
        return complain(flavour.error(), wrongCall);
    const Result<emit::Loader> loader = parseChoice<emit::Loader>(options.loader, "--loader");
    if (!loader)
        return complain(loader.error(), wrongCall);
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    if (!options.pretended.empty() && !pretence->limitsTextures())
        noteUnused("--pretend", "of the driver only the largest sizes of textures concern a program");
    SceneArgument scene = options.scene;
    scene.limits = pretence->facts().limits();
    if (const Result<void> possible = checkFilesBeside(options); !possible)
        return complain(possible.error(), wrongCall);
    const Result<Output> out = Output::open(options.out);
    if (!out)
        return complain(out.error());
    emit::ProgramOptions asked;
    asked.title.clear();
    asked.loader = *loader;
    asked.selfContained = options.selfContained;
    if (!isStandardOutput(options.out))
        asked.source = options.out;
    auto program =
        programOf(scene, *flavour, asked, options.files ? FilePlaces::Beside : FilePlaces::WhereTheyAre);
    if (!program)
        return complain(program.error().error, program.error().code);
    if (const Result<void> apart =
            checkOutputsApart(std::array{NamedOutput{"--out", options.out}}, program->madeFrom);
        !apart)
        return complain(apart.error(), wrongCall);
    const std::string text = textOf(program->lines, false);
    if (options.cmake) {
        asked.source = std::filesystem::path(options.out).filename().string();
        const std::string lists = cmakeLists(program->lines, asked);
        const ByteView bytes = viewBytes(lists);
        program->files.push_back({"CMakeLists.txt", Bytes(bytes.begin(), bytes.end())});
    }
    const Result<void> written = writeBeside(options.out, *out, text, program->files);
    return written ? success : complain(written.error());
}

} // namespace

void addEmit(CommandLine& line) {
    Command& command = line.command("emit", "Write a scene as a complete program in C.");
    auto options = std::make_shared<EmitOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.option("--as", options->flavour, "The target of the program." + explainChoices<emit::Flavour>(),
                   {.value = "FLAVOUR", .showsDefault = true, .offers = {choiceNames<emit::Flavour>}});
    command.option("-o,--out", options->out, "The file to write; - for standard output.",
                   {.value = "FILE", .showsDefault = true});
    command.flag("--files", options->files,
                 "Write the lesson's BMP, TGA and DDS files next to the program, which reads them. "
                 "Default: their texels are part of the program.");
    command.flag("--self-contained", options->selfContained,
                 "Draw round shapes and make mipmaps with the program's own code, without GLU.");
    command.option("--pretend", options->pretended,
                   "Write the program for a driver with smaller textures: max-texture-size=N, "
                   "max-3d-texture-size=N or max-cube-map-size=N, where the scene asks for smaller levels.",
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    command.option("--loader", options->loader,
                   "Where the functions of OpenGL after 1.1 come from." + explainChoices<emit::Loader>(),
                   {.value = "LOADER", .showsDefault = true, .offers = {choiceNames<emit::Loader>}});
    command.flag("--cmake", options->cmake,
                 "Write a CMakeLists.txt next to the program. Another one is not replaced.");
    command.footer(
        "One file with the command to compile it at the top. It needs GLFW and OpenGL, and GLU for quadrics "
        "and gluBuild2DMipmaps. In a framebuffer "
        "object it draws the same pixels as \"texshot shot\"; in its window a driver may round "
        "differently. It is animated like the scene and turns with the mouse. Simple patterns are "
        "computed; the texels of other images and large meshes are arrays at the end. With --lesson the "
        "step's text is at the top, and the relevant calls have comments.\n"
        "The shaders of glsl are those of the GLSL tab. If OpenGL 3.3 can't express the scene, or a key "
        "frame changes something that no call or uniform sets, such as a model's shape, an error names it "
        "and nothing is written.\n"
        "Exit status: 0 done, 1 the scene or an image can't be read or expressed, 2 invalid arguments.");
    command.onCall([options] { return emitProgram(*options); });
}

} // namespace texplorer::screenshot

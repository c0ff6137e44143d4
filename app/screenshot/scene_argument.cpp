#include "app/screenshot/scene_argument.h"

#include "core/base/file_io.h"
#include "core/scene/json.h"
#include "core/scene/params.h"

namespace texplorer::screenshot {
namespace {

Result<void> assign(Scene& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
        return fail(ErrorCode::OutOfRange, "expected PATH=VALUE, found \"" + assignment + "\"", "--set");
    return setParam(scene, std::string_view(assignment).substr(0, equals),
                    std::string_view(assignment).substr(equals + 1));
}

} // namespace

void addSceneArgument(CLI::App& command, SceneArgument& argument) {
    command.add_option(
        "SCENE", argument.file,
        "A scene file (JSON). Without one: the cube and the sphere that Texplorer starts with.");
    command
        .add_option("--set", argument.assignments,
                    "Change one parameter, as in textures[0].minFilter=GL_NEAREST. May be given again; "
                    "\"texshot params\" lists every path.")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
}

tl::expected<OpenedScene, ExitCode> openScene(const SceneArgument& argument) {
    OpenedScene opened{defaultScene(), ImageSource{}};
    if (!argument.file.empty()) {
        const Result<std::string> text = readText(argument.file, maxSceneBytes);
        if (!text)
            return tl::unexpected(complain(text.error()));
        Result<Scene> scene = parseScene(*text);
        if (!scene)
            return tl::unexpected(complain(inScene(argument, scene.error())));
        opened.scene = *std::move(scene);
        opened.images = ImageSource{std::filesystem::path(argument.file).parent_path()};
    }
    for (const std::string& assignment : argument.assignments) {
        if (const auto assigned = assign(opened.scene, assignment); !assigned)
            return tl::unexpected(complain(assigned.error(), wrongCall));
    }
    return opened;
}

Error inScene(const SceneArgument& argument, const Error& error) {
    return argument.file.empty() ? error : Error{error.code, describe(error), argument.file};
}

} // namespace texplorer::screenshot

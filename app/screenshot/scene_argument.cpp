#include "app/screenshot/scene_argument.h"

#include "app/screenshot/choice_argument.h"
#include "core/base/file_io.h"
#include "core/preset/preset.h"
#include "core/scene/params/json.h"
#include "core/scene/params/params.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

Result<void> assign(Scene& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    return setParam(scene, std::string_view(assignment).substr(0, equals),
                    std::string_view(assignment).substr(equals + 1));
}

/// Told while the command line is read, before a value that stands apart is taken for a scene's file.
std::string checkAssignment(const std::string& text) {
    return text.find('=') != std::string::npos
               ? std::string()
               : fmt::format("expected PATH=VALUE, joined by = without a space, found \"{}\"", text);
}

Result<void> applyPresetNamed(Scene& scene, const std::string& name) {
    const Preset* preset = findPreset(name);
    if (preset)
        return applyPreset(*preset, scene);
    std::string names;
    for (const Preset& each : presets())
        names.append(names.empty() ? "" : ", ").append(each.name);
    return refuseChoice(names, name, "--preset");
}

} // namespace

void addSceneArgument(Command& command, SceneArgument& argument) {
    command.option("SCENE", argument.file,
                   "A scene file (JSON). Without one: the cube and the sphere that Texplorer starts with.");
    command.option("--set", argument.assignments,
                   "Change one parameter, as in textures[0].minFilter=GL_NEAREST. May be given again; "
                   "\"texshot params\" lists every path.",
                   {.value = "PATH=VALUE", .oneEach = true, .check = checkAssignment});
    command.option("--preset", argument.presets,
                   "What a textbook shows of a setting, as in alpha-test, after every --set. May be given "
                   "again; \"texshot presets\" lists them.",
                   {.value = "PRESET", .oneEach = true});
}

tl::expected<OpenedScene, SceneProblem> openScene(const SceneArgument& argument) {
    OpenedScene opened{defaultScene(), ImageSource{}};
    if (!argument.file.empty()) {
        const Result<std::string> text = readText(argument.file, maxSceneBytes);
        if (!text)
            return tl::unexpected(SceneProblem{text.error(), failure});
        Result<Scene> scene = parseScene(*text);
        if (!scene)
            return tl::unexpected(SceneProblem{inScene(argument, scene.error()), failure});
        opened.scene = *std::move(scene);
        opened.images = ImageSource{std::filesystem::path(argument.file).parent_path()};
    }
    for (const std::string& assignment : argument.assignments) {
        if (const auto assigned = assign(opened.scene, assignment); !assigned)
            return tl::unexpected(SceneProblem{assigned.error(), wrongCall});
    }
    for (const std::string& preset : argument.presets) {
        if (const auto applied = applyPresetNamed(opened.scene, preset); !applied)
            return tl::unexpected(SceneProblem{applied.error(), wrongCall});
    }
    return opened;
}

Error inScene(const SceneArgument& argument, const Error& error) {
    return argument.file.empty() ? error : Error{error.code, describe(error), argument.file};
}

} // namespace texplorer::screenshot

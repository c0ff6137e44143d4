#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/transformations.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace texplorer::emit {
namespace {

Holder viewHolder(const Scene& scene) {
    static const View identity{.distance = 0}; // what makes no matrix
    return {viewTable(), &scene.view, &identity, keyOf<&Scene::view>(), keyOf<&Scene::view>(), {}};
}

/// What the mouse changes is a variable. Of what moves by key frames it is what is added to them, or what
/// they are multiplied by.
void declareVariable(Emission& emission, MemberId member, std::string_view what, std::string_view beside) {
    const View& view = emission.scene.view;
    const auto row = std::ranges::find(viewTable().params, member, &ParamRow::member);
    const std::string path = fmt::format("{}.{}", keyOf<&Scene::view>(), row->key);
    const bool moves = emission.keys.moves(path);
    const float still = member == memberId<&View::distance> ? 1.0F : 0.0F;
    emission.atStart.add({plain(fmt::format("static GLfloat {} = ", row->key)),
                          moves ? number(still) : number(std::get<float>(row->read(&view)), path),
                          plain("; "),
                          {Part::Kind::Comment, fmt::format("/* {} */", moves ? beside : what)}});
}

/// What multiplies by the matrix of gluPerspective.
Part perspectiveName(Emission& emission) {
    if (emission.callsGlu)
        return call("gluPerspective");
    emission.use(CFunction::Perspective);
    return plain("perspective");
}

} // namespace

void writeProjection(Emission& emission) {
    CodeWriter& writer = emission.writer;
    const View& view = emission.scene.view;
    const Holder holder = viewHolder(emission.scene);
    writer.heading("background");
    writer.add("glViewport(0, 0, width, height);");
    writer.row(holder, memberId<&View::background>);
    writer.add("glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);");
    writer.row(holder, memberId<&View::perspectiveHint>);
    writer.heading("projection");
    writer.add("const GLfloat aspect = (GLfloat)width / (GLfloat)height;");
    const std::string distance = cameraVariable(emission, memberId<&View::distance>);
    writer.add(fmt::format("const GLdouble farthest = 4.0 * {} + 400.0;", distance));
    writer.add(fmt::format("glMatrixMode({});", projectionMode));
    writer.add("glLoadIdentity();");
    const Part angle = number(view.fieldOfView, pathOf<&Scene::view, &View::fieldOfView>());
    if (view.projection == Projection::Orthographic) {
        emission.use(CFunction::Pi);
        writer.add({plain(fmt::format("const GLdouble half = {} * tan(", distance)), angle,
                    plain(" * pi / 180 / 2);")});
        writer.add("glOrtho(-half * aspect, half * aspect, -half, half, -farthest, farthest);");
    } else {
        writer.add({perspectiveName(emission), plain("("), angle,
                    plain(fmt::format(", aspect, {} / 50.0, farthest);", distance))});
    }
    writer.add(fmt::format("glMatrixMode({});", modelViewMode));
}

void writeMatrices(Emission& emission, bool draws) {
    CodeWriter& writer = emission.writer;
    const View& view = emission.scene.view;
    writer.heading("background");
    writer.add("glViewport(0, 0, width, height);");
    writer.row(viewHolder(emission.scene), memberId<&View::background>);
    writer.add("glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);");
    if (!draws)
        return;
    writer.heading("projection");
    writer.add("const GLfloat aspect = (GLfloat)width / (GLfloat)height;");
    const std::string distance = cameraVariable(emission, memberId<&View::distance>);
    writer.add(fmt::format("const double farthest = 4.0 * {} + 400.0;", distance));
    const Part angle = number(view.fieldOfView, pathOf<&Scene::view, &View::fieldOfView>());
    if (view.projection == Projection::Orthographic) {
        emission.use(CFunction::Orthographic);
        emission.use(CFunction::Degree);
        writer.add(
            {plain(fmt::format("const double half = {} * tan(", distance)), angle, plain(" * degree / 2);")});
        writer.add("const Matrix projection = orthographic(half * aspect, half, farthest);");
    } else {
        emission.use(CFunction::Frustum);
        writer.add({plain("const Matrix projection = perspective("), angle,
                    plain(fmt::format(", aspect, {} / 50.0, farthest);", distance))});
    }
    writer.heading("camera");
    MatrixProduct product(emission, "view", true);
    addView(emission, product);
    product.finish();
}

void writeLight(Emission& emission) {
    static const Light initial;
    CodeWriter& writer = emission.writer;
    const Scene& scene = emission.scene;
    const std::string& path = keyOf<&Scene::light>();
    const Holder holder{lightTable(), &scene.light, &initial, path, path, path};
    writer.heading("light 0, in eye coordinates");
    writer.add("glLoadIdentity();", false); // as the matrix is at the start
    if (emission.isLit)
        writer.add("glEnable(GL_LIGHT0);");
    if (emission.needsNormals)
        writer.add({plain("glEnable(GL_NORMALIZE); "),
                    {Part::Kind::Comment, "/* normals have the length 1 where models are scaled, too */"}});
    for (const ParamRow& row : holder.table.params)
        writer.row(holder, row, emission.isLit);
}

void writeMovingLight(Emission& emission) {
    static const Light initial;
    CodeWriter& writer = emission.writer;
    const std::string& path = keyOf<&Scene::light>();
    const Holder holder{lightTable(), &emission.scene.light, &initial, path, path, path};
    const std::size_t start = writer.size();
    writer.heading("light 0, in eye coordinates");
    writer.add("glLoadIdentity();");
    const std::size_t size = writer.size();
    writer.take(Taking::Moving);
    for (const ParamRow& row : holder.table.params)
        writer.row(holder, row);
    writer.take(Taking::All);
    if (writer.size() == size)
        writer.truncate(start);
}

void declareCamera(Emission& emission) {
    declareVariable(emission, memberId<&View::azimuth>, "degrees around the y axis",
                    "degrees that the mouse adds around the y axis");
    declareVariable(emission, memberId<&View::elevation>, "degrees above the horizon",
                    "degrees that the mouse adds above the horizon");
    declareVariable(emission, memberId<&View::distance>, "of the eye from what it looks at",
                    "times as far as the key frames say: by the mouse wheel");
}

std::string cameraVariable(Emission& emission, MemberId member) {
    const std::string key(findKey(member));
    const std::string path = fmt::format("{}.{}", keyOf<&Scene::view>(), key);
    return emission.keys.moves(path) ? emission.keys.use(path) : key;
}

void writeCamera(Emission& emission) {
    MatrixCalls calls(emission);
    addView(emission, calls);
}

std::vector<std::string> lightPaths() {
    return {pathOf<&Scene::light, &Light::position>(), pathOf<&Scene::light, &Light::projector>()};
}

void writeLightProjection(Emission& emission) {
    const Light& light = emission.scene.light;
    const Projector& projector = light.projector;
    const auto computed = [](const Scene& scene) { // what isn't the value of one parameter
        const LightView view = lightView(scene.light);
        const bool isParallel = scene.light.position.w == 0;
        const bool isCut = view.farthest != double{scene.light.projector.farthest};
        return std::tuple(isParallel, isParallel ? view.extent : 0, isCut, isCut ? view.farthest : 0);
    };
    const auto [isParallel, extent, isCut, farthest] =
        emission.keys.decided(emission.scene, lightPaths(), computed, computedLight);
    std::vector<Part> range{
        plain(", "),
        number(projector.nearest, pathOf<&Scene::light, &Light::projector, &Projector::nearest>()),
        plain(", "),
        isCut ? plain(fmt::format("{}", farthest))
              : number(projector.farthest, pathOf<&Scene::light, &Light::projector, &Projector::farthest>()),
        plain(");")};
    std::vector<Part> parts;
    if (isParallel) {
        if (!std::exchange(emission.hasLightExtent, true))
            emission.atStart.add(
                {plain(fmt::format("static const GLdouble lightExtent = {}; ", extent)),
                 {Part::Kind::Comment, "/* half of what the light sees, in width and height */"}});
        parts = {call("glOrtho"), plain("(-lightExtent, lightExtent, -lightExtent, lightExtent")};
    } else {
        parts = {perspectiveName(emission), plain("("),
                 number(projector.fieldOfView,
                        pathOf<&Scene::light, &Light::projector, &Projector::fieldOfView>()),
                 plain(", 1.0")};
    }
    append(parts, std::move(range));
    emission.writer.add(std::move(parts));
}

void writeLightView(Emission& emission, const std::string& variable) {
    const glm::mat4 view = emission.keys.decided(
        emission.scene, lightPaths(),
        [](const Scene& scene) { return glm::mat4(lightView(scene.light).view); }, computedLight);
    emission.writer.floats(variable, numbers({glm::value_ptr(view), 16}));
    emission.writer.add({call("glMultMatrixf"), plain(fmt::format("({});", variable))});
}

} // namespace texplorer::emit

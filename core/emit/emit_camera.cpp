#include "core/emit/emission.h"
#include "core/gl/argument_names.h"
#include "core/scene/animation.h"
#include "core/scene/params/keys.h"

#include <algorithm>

namespace texplorer::emit {
namespace {

Holder viewHolder(const Scene& scene) {
    static const View identity{.distance = 0}; // what makes no matrix
    return {viewTable(), &scene.view, &identity, keyOf<&Scene::view>(), keyOf<&Scene::view>(), {}};
}

Part plainNumber(double value) {
    return number(static_cast<float>(value), {}, -1, Literal::Double);
}

/// The camera's own calls come in the order in which the matrices are multiplied: what is called last is done
/// to a vertex first.
constexpr std::array cameraOrder{memberId<&View::distance>, memberId<&View::roll>, memberId<&View::elevation>,
                                 memberId<&View::azimuth>, memberId<&View::target>};

} // namespace

void writeProjection(Emission& emission) {
    CodeWriter& writer = emission.writer;
    const View& view = emission.scene.view;
    const Holder holder = viewHolder(emission.scene);
    writer.heading("background and projection");
    writer.row(holder, memberId<&View::background>);
    writer.add("glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);");
    writer.row(holder, memberId<&View::perspectiveHint>);
    writer.add("GLint viewport[4];");
    writer.add("glGetIntegerv(GL_VIEWPORT, viewport);");
    writer.add("GLdouble aspect = (GLdouble)viewport[2] / viewport[3];");
    writer.add(fmt::format("glMatrixMode({});", projectionMode));
    writer.add("glLoadIdentity();");
    const auto [near, far] = clipPlanes(view);
    if (view.projection == Projection::Orthographic) {
        const Part half = plainNumber(halfHeightAtTarget(view));
        writer.add({call("glOrtho"), plain("(-"), half, plain(" * aspect, "), half, plain(" * aspect, -"),
                    half, plain(", "), half, plain(", -"), plainNumber(far), plain(", "), plainNumber(far),
                    plain(");")});
    } else {
        const Part angle =
            number(view.fieldOfView, pathOf<&Scene::view, &View::fieldOfView>(), -1, Literal::Double);
        writer.add(callWith("gluPerspective",
                            {angle, plain(", aspect, "), plainNumber(near), plain(", "), plainNumber(far)}));
    }
    writer.add(fmt::format("glMatrixMode({});", modelViewMode));
}

void writeLight(Emission& emission) {
    static const Light initial;
    CodeWriter& writer = emission.writer;
    const Scene& scene = emission.scene;
    const bool isLit =
        std::ranges::any_of(scene.passes, [](const Pass& pass) { return pass.enabled && pass.lighting; });
    const std::string& path = keyOf<&Scene::light>();
    const Holder holder{lightTable(), &scene.light, &initial, path, path, path};
    writer.heading("light 0, in eye coordinates");
    writer.add("glLoadIdentity();", false); // as the matrix is at the start
    if (isLit)
        writer.add("glEnable(GL_LIGHT0);");
    if (emission.needsNormals)
        writer.add("glEnable(GL_NORMALIZE);");
    for (const ParamRow& row : holder.table.params)
        writer.row(holder, row);
}

void writeCamera(Emission& emission) {
    emission.writer.heading("camera");
    emission.writer.add("glLoadIdentity();", false);
    const Holder holder = viewHolder(emission.scene);
    for (const MemberId member : cameraOrder)
        emission.writer.row(holder, member);
}

} // namespace texplorer::emit

#include "texplorer/scene/model_mesh.h"

#include <algorithm>
#include <array>

namespace texplorer {

ShapeOptions shapeOptions(const Model& model) {
    return {model.shape,       model.slices,     model.stacks,     model.topRadius,
            model.innerRadius, model.tubeRadius, model.startAngle, model.sweepAngle};
}

Mesh meshOf(const Model& model) {
    return model.shape == Shape::Mesh ? makeMesh(model.mesh) : makeMesh(shapeOptions(model));
}

std::size_t vertexCountOf(const Model& model) {
    return model.shape == Shape::Mesh ? model.mesh.positions.size() : vertexCount(shapeOptions(model));
}

int partCorners(Primitive primitive) {
    switch (primitive) {
    case Primitive::Points:
        return 1;
    case Primitive::Lines:
    case Primitive::LineLoop:
    case Primitive::LineStrip:
        return 2;
    default:
        return 3;
    }
}

int partCorners(const Model& model) {
    return model.shape == Shape::Mesh ? partCorners(model.mesh.primitive) : 3;
}

bool isClosed(const Model& model) {
    constexpr std::array closed{Shape::Cube, Shape::Sphere, Shape::Torus, Shape::Teapot};
    return std::ranges::find(closed, model.shape) != closed.end();
}

const Material& materialOf(const Scene& scene, const Model& model) {
    return model.ownMaterial ? model.material : scene.material;
}

} // namespace texplorer

// Shapes that are turned about an axis: a function of the program makes their mesh.

#include "texplorer/emit/emission.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <cmath>

namespace texplorer::emit {
namespace {

/// From where the disk begins, and how far it goes around: as core/mesh/disk.cpp has it.
std::vector<Part> sectorOf(const Model& model, const Part& start, const Part& sweep) {
    if (model.shape == Shape::Disk)
        return {plain("0.0, 360.0")};
    if (std::abs(model.sweepAngle) > 360)
        return {start, plain(", 360.0")};
    if (model.sweepAngle >= 0)
        return {start, plain(", "), sweep};
    return {start, plain(" + "), sweep, plain(", "),
            plain(literal(-model.sweepAngle, Literal::Float))}; // backwards around it is the same sector
}

} // namespace

std::vector<Part> shapeCall(Emission& emission, std::size_t index) {
    const Model& model = emission.scene.models[index];
    const auto own = [path = elementOf<&Scene::models>(index)](const std::string& key) {
        return fmt::format("{}.{}", path, key);
    };
    const Part slices = whole(model.slices, own(keyOf<&Model::slices>()));
    const Part stacks = whole(model.stacks, own(keyOf<&Model::stacks>()));
    const Part comma = plain(", ");
    switch (model.shape) {
    case Shape::Sphere:
        emission.use(CFunction::Sphere);
        return {plain("sphere("), slices, comma, stacks, plain(")")};
    case Shape::Cylinder:
        emission.use(CFunction::Cylinder);
        return {plain("cylinder("),
                number(model.topRadius, own(keyOf<&Model::topRadius>())),
                comma,
                slices,
                comma,
                stacks,
                plain(")")};
    case Shape::Torus:
        emission.use(CFunction::Torus);
        // The tube has a triangle around it at least (core/mesh/mesh.h).
        return {plain("torus("), number(model.tubeRadius, own(keyOf<&Model::tubeRadius>())),
                comma,           slices,
                comma,           model.stacks < minSlices ? plain(std::to_string(minSlices)) : stacks,
                plain(")")};
    default: {
        emission.use(CFunction::Disk);
        std::vector<Part> parts{plain("disk("), number(model.innerRadius, own(keyOf<&Model::innerRadius>())),
                                comma,          slices,
                                comma,          stacks,
                                comma};
        append(parts, sectorOf(model, number(model.startAngle, own(keyOf<&Model::startAngle>())),
                               number(model.sweepAngle, own(keyOf<&Model::sweepAngle>()))));
        parts.push_back(plain(")"));
        return parts;
    }
    }
}

} // namespace texplorer::emit

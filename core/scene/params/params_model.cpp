#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::colors;
using build::list;
using build::param;
using build::texCoords;

constexpr std::string_view texCoordHelp =
    "s, t, r and q of every vertex for this texture unit. An empty list takes what the mesh gives.";

constexpr std::array meshRows{
    param<&MeshData::primitive>("primitive", "Mesh", "Primitive", "glBegin({})",
                                "What the vertices are made into: triangles, lines, points."),
    list<&MeshData::positions>("positions", "Mesh", "Positions", "glVertex3fv({})",
                               "x, y and z of every vertex.", maxMeshVertices),
    list<&MeshData::normals>("normals", "Mesh", "Normals", "glNormal3fv({})",
                             "Where the surface looks at every vertex, of any length. None: towards +z.",
                             maxMeshVertices),
    colors<&MeshData::colors>("colors", "Mesh", "Colours", "glColor4fv({})",
                              "A colour for every vertex, in the place of glColor. None: glColor.",
                              maxMeshVertices),
    list<&MeshData::texCoords>("texCoords", "Mesh", "Coordinates", "glTexCoord4fv({})",
                               "s, t, r and q of every vertex, for all units that have no list of their own.",
                               maxMeshVertices),
    list<&MeshData::indices>("indices", "Mesh", "Indices", "glArrayElement({})",
                             "The vertices in the order in which they are drawn, counted from 0. None: one "
                             "after the other.",
                             maxMeshIndices, {0, static_cast<float>(maxMeshVertices - 1), 1, {}}),
};
static_assert(meshRows.size() == 6 && meshRows.size() == build::memberCount<MeshData>());

constexpr std::array modelRows{
    param<&Model::name>("name", "Shape", "Name", "", "What it is called in lists. It changes nothing else."),
    param<&Model::shape>("shape", "Shape", "Shape", "", "Which mesh is drawn."),
    param<&Model::visible>("visible", "Shape", "Visible", "", "Whether it is drawn at all."),
    param<&Model::slices>("slices", "Shape", "Slices", "",
                          "How many strips a round shape has around its axis.",
                          {minSlices, maxSubdivision, 0.2F, {}}),
    param<&Model::stacks>(
        "stacks", "Shape", "Stacks", "",
        "How many rings a round shape has: along its axis, around a torus's tube, from a disk's rim inwards, "
        "or along each patch of a teapot, which has at most 24.",
        {minStacks, maxSubdivision, 0.2F, {}}),
    param<&Model::topRadius>("topRadius", "Shape", "Top radius", "",
                             "Of a cylinder, whose base has the radius 1; 0 makes a cone.",
                             {0, 10, 0.01F, {}}),
    param<&Model::innerRadius>("innerRadius", "Shape", "Inner radius", "",
                               "Of the hole in a disk, whose outer radius is 1.", {0, 0.99F, 0.005F, {}}),
    param<&Model::tubeRadius>("tubeRadius", "Shape", "Tube radius", "",
                              "Of a torus, whose ring has the radius 1.", {0, 1, 0.005F, {}}),
    param<&Model::startAngle>("startAngle", "Shape", "Start angle", "",
                              "Where a partial disk begins: from the top, clockwise.",
                              {-360, 360, 0.5F, "deg"}),
    param<&Model::sweepAngle>("sweepAngle", "Shape", "Sweep angle", "", "How far a partial disk goes around.",
                              {-360, 360, 0.5F, "deg"}),
    param<&Model::lineWidth>("lineWidth", "Shape", "Line width", "glLineWidth({})",
                             "Of lines, in pixels; rounded to whole ones.", {0.5F, 64, 0.05F, "pixels"}),
    param<&Model::pointSize>("pointSize", "Shape", "Point size", "glPointSize({})",
                             "Of points, in pixels; rounded to whole ones.", {0.5F, 64, 0.05F, "pixels"}),
    param<&Model::position>("position", "Placement", "Position", "glTranslatef({})", "Where its centre is.",
                            {-1000, 1000, 0.01F, {}}),
    param<&Model::rotation>("rotation", "Placement", "Rotation", "",
                            "Turns it about the x, y and z axis; what it is at time 0.",
                            {-360, 360, 0.5F, "deg"}),
    param<&Model::rotationOrder>("rotationOrder", "Placement", "Order", "",
                                 "Which of the three rotations is done to the model first."),
    param<&Model::spin>("spin", "Placement", "Spin", "",
                        "How fast each of the three rotations grows with time.",
                        {-3600, 3600, 0.5F, "deg/s"}),
    param<&Model::size>("size", "Placement", "Size", "glScalef({}, {}, {})",
                        "A factor on the whole mesh. Textures grow with it, for they stick to the vertices.",
                        {0.01F, 100, 0.01F, {}}),
    param<&Model::scale>("scale", "Placement", "Scale", "glScalef({})",
                         "A factor for each axis, beside the size.", {0.01F, 100, 0.01F, {}}),
    param<&Model::attachment>("attachment", "Placement", "Attached to", "",
                              "Whether it stays in the world or moves with the camera."),
    param<&Model::ownMaterial>("ownMaterial", "Material", "Own material", "",
                               "Whether it has a material of its own instead of the scene's."),
    texCoords<&Model::texCoords, 0>("texCoords0", "Texture coordinates", "Unit 0",
                                    "glMultiTexCoord4fv(GL_TEXTURE0, {})", texCoordHelp),
    texCoords<&Model::texCoords, 1>("texCoords1", "Texture coordinates", "Unit 1",
                                    "glMultiTexCoord4fv(GL_TEXTURE1, {})", texCoordHelp),
    texCoords<&Model::texCoords, 2>("texCoords2", "Texture coordinates", "Unit 2",
                                    "glMultiTexCoord4fv(GL_TEXTURE2, {})", texCoordHelp),
    texCoords<&Model::texCoords, 3>("texCoords3", "Texture coordinates", "Unit 3",
                                    "glMultiTexCoord4fv(GL_TEXTURE3, {})", texCoordHelp),
};
// The array of coordinates is one member and has a row for each unit.
static_assert(modelRows.size() == 24 && modelRows.size() + 2 == build::memberCount<Model>() - 1 + maxUnits);

} // namespace

const StructTable& meshTable() {
    static const StructTable table{"Mesh", meshRows, {}};
    return table;
}

const StructTable& modelTable() {
    static const std::array children{
        build::single<&Model::material>("material", "Material", modelMaterialTable()),
        build::single<&Model::mesh>("mesh", "Mesh", meshTable()),
    };
    static const StructTable table{"Model", modelRows, children};
    return table;
}

} // namespace texplorer

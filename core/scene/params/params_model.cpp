#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::colors;
using build::list;
using build::param;
using build::texCoords;

constexpr std::string_view texCoordHelp =
    "s, t, r and q of every vertex for this texture unit. If empty, the coordinates of the mesh are used.";

constexpr std::array meshRows{
    param<&MeshData::primitive>("primitive", "Mesh", "Primitive", "glBegin({})",
                                "What is drawn from the vertices: triangles, lines or points."),
    list<&MeshData::positions>("positions", "Mesh", "Positions", "glVertex3fv({})",
                               "x, y and z of every vertex.", maxMeshVertices),
    list<&MeshData::normals>("normals", "Mesh", "Normals", "glNormal3fv({})",
                             "The direction in which the surface looks at every vertex, of any length. If "
                             "empty: +z.",
                             maxMeshVertices),
    colors<&MeshData::colors>("colors", "Mesh", "Colours", "glColor4fv({})",
                              "A colour for every vertex, instead of glColor. If empty: glColor.",
                              maxMeshVertices),
    list<&MeshData::texCoords>("texCoords", "Mesh", "Coordinates", "glTexCoord4fv({})",
                               "s, t, r and q of every vertex, for all units without a list of their own.",
                               maxMeshVertices),
    list<&MeshData::indices>("indices", "Mesh", "Indices", "glArrayElement({})",
                             "The vertices in the order in which they are drawn, counted from 0. If empty: "
                             "one after the other.",
                             maxMeshIndices, {0, static_cast<float>(maxMeshVertices - 1), 1, {}}),
};
static_assert(meshRows.size() == 6 && meshRows.size() == build::memberCount<MeshData>());

constexpr std::array modelRows{
    param<&Model::name>("name", "Shape", "Name", "",
                        "The name of the model in lists. It has no other "
                        "effect."),
    param<&Model::shape>("shape", "Shape", "Shape", "", "The mesh that is drawn."),
    param<&Model::visible>("visible", "Shape", "Visible", "", "Whether the model is drawn."),
    param<&Model::slices>("slices", "Shape", "Slices", "",
                          "The number of strips around the axis of a round shape.",
                          {minSlices, maxSubdivision, 0.2F, {}}),
    param<&Model::stacks>(
        "stacks", "Shape", "Stacks", "",
        "The number of rings of a round shape: along its axis, around the tube of a torus, from the rim of "
        "a disk inwards, or along each patch of a teapot (at most 24).",
        {minStacks, maxSubdivision, 0.2F, {}}),
    param<&Model::topRadius>("topRadius", "Shape", "Top radius", "",
                             "The top radius of a cylinder, whose base has radius 1. 0 makes a cone.",
                             {0, 10, 0.01F, {}}),
    param<&Model::innerRadius>("innerRadius", "Shape", "Inner radius", "",
                               "The radius of the hole in a disk, whose outer radius is 1.",
                               {0, 0.99F, 0.005F, {}}),
    param<&Model::tubeRadius>("tubeRadius", "Shape", "Tube radius", "",
                              "The radius of the tube of a torus, whose ring has radius 1.",
                              {0, 1, 0.005F, {}}),
    param<&Model::startAngle>("startAngle", "Shape", "Start angle", "",
                              "The angle at which a partial disk begins, clockwise from the top.",
                              {-360, 360, 0.5F, "deg"}),
    param<&Model::sweepAngle>("sweepAngle", "Shape", "Sweep angle", "",
                              "The angle that a partial disk "
                              "covers.",
                              {-360, 360, 0.5F, "deg"}),
    param<&Model::lineWidth>("lineWidth", "Shape", "Line width", "glLineWidth({})",
                             "The width of lines in pixels, rounded to a whole number.",
                             {0.5F, 64, 0.05F, "pixels"}),
    param<&Model::pointSize>("pointSize", "Shape", "Point size", "glPointSize({})",
                             "The size of points in pixels, rounded to a whole number.",
                             {0.5F, 64, 0.05F, "pixels"}),
    param<&Model::position>("position", "Placement", "Position", "glTranslatef({})",
                            "The position of the "
                            "model's centre.",
                            {-1000, 1000, 0.01F, {}}),
    param<&Model::rotation>("rotation", "Placement", "Rotation", "",
                            "The rotation about the x, y and z axes at time 0.", {-360, 360, 0.5F, "deg"}),
    param<&Model::rotationOrder>("rotationOrder", "Placement", "Order", "",
                                 "The order of the three rotations."),
    param<&Model::spin>("spin", "Placement", "Spin", "",
                        "How fast each of the three rotations changes with time.",
                        {-3600, 3600, 0.5F, "deg/s"}),
    param<&Model::size>("size", "Placement", "Size", "glScalef({}, {}, {})",
                        "Scales the whole mesh. Textures grow with it, since they stick to the vertices.",
                        {0.01F, 100, 0.01F, {}}),
    param<&Model::scale>("scale", "Placement", "Scale", "glScalef({})",
                         "Scales each axis, in addition to the size.", {0.01F, 100, 0.01F, {}}),
    param<&Model::attachment>("attachment", "Placement", "Attached to", "",
                              "Whether the model stays in the world or moves with the camera."),
    param<&Model::ownMaterial>("ownMaterial", "Material", "Own material", "",
                               "Whether the model has a material of its own instead of the scene's."),
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

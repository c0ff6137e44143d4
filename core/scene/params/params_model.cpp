#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::colors;
using build::list;
using build::param;
using build::vertexList;

constexpr std::string_view texCoordHelp = N_(
    "s, t, r and q of every vertex for this texture unit. If empty, the coordinates of the mesh are used.");

constexpr std::string_view noTexCoordHelp = N_(
    "The vertices without glTexCoord for this unit, from 0. Each has the coordinates of the vertex sent before "
    "it.");
constexpr Range vertexNumbers{0, static_cast<float>(build::maxTexCoords - 1), 1, {}};

constexpr std::array meshRows{
    param<&MeshData::primitive>("primitive", N_("Mesh"), N_("Primitive"), "glBegin({})",
                                N_("What is drawn from the vertices: triangles, lines or points.")),
    param<&MeshData::file>("file", N_("Mesh"), N_("File"), "",
                           N_("An OBJ file that has the vertices, relative to the scene file. If empty, the "
                              "scene has them.")),
    param<&MeshData::part>("part", N_("Mesh"), N_("Part of the file"), "",
                           N_("The part of the file: its objects and groups with one material, counted from "
                              "0."),
                           {0, static_cast<float>(maxModels - 1), 0.05F, {}}),
    list<&MeshData::positions>("positions", N_("Mesh"), N_("Positions"), "glVertex3fv({})",
                               N_("x, y and z of every vertex."), maxMeshVertices),
    list<&MeshData::normals>("normals", N_("Mesh"), N_("Normals"), "glNormal3fv({})",
                             N_("The direction in which the surface looks at every vertex, of any length. If "
                                "empty: +z."),
                             maxMeshVertices),
    colors<&MeshData::colors>("colors", N_("Mesh"), N_("Colours"), "glColor4fv({})",
                              N_("A colour for every vertex, instead of glColor. If empty: glColor."),
                              maxMeshVertices),
    list<&MeshData::texCoords>(
        "texCoords", N_("Mesh"), N_("Coordinates"), "glTexCoord4fv({})",
        N_("s, t, r and q of every vertex, for all units without a list of their own."), maxMeshVertices),
    list<&MeshData::indices>(
        "indices", N_("Mesh"), N_("Indices"), "glArrayElement({})",
        N_("The vertices in the order in which they are drawn, counted from 0. If empty: "
           "one after the other."),
        maxMeshIndices, {0, static_cast<float>(maxMeshVertices - 1), 1, {}}),
};
static_assert(meshRows.size() == 8 && meshRows.size() == build::memberCount<MeshData>());

constexpr std::array modelRows{
    param<&Model::name>("name", N_("Shape"), N_("Name"), "",
                        N_("The name of the model in lists. It has no other "
                           "effect.")),
    param<&Model::shape>("shape", N_("Shape"), N_("Shape"), "", N_("The mesh that is drawn.")),
    param<&Model::visible>("visible", N_("Shape"), N_("Visible"), "", N_("Whether the model is drawn.")),
    param<&Model::slices>("slices", N_("Shape"), N_("Slices"), "",
                          N_("The number of strips around the axis of a round shape."),
                          {minSlices, maxSubdivision, 0.2F, {}}),
    param<&Model::stacks>(
        "stacks", N_("Shape"), N_("Stacks"), "",
        N_("The number of rings of a round shape: along its axis, around the tube of a torus, from the rim of "
           "a disk inwards, or along each patch of a teapot (at most 24)."),
        {minStacks, maxSubdivision, 0.2F, {}}),
    param<&Model::topRadius>("topRadius", N_("Shape"), N_("Top radius"), "",
                             N_("The top radius of a cylinder, whose base has radius 1. 0 makes a cone."),
                             {0, 10, 0.01F, {}}),
    param<&Model::innerRadius>("innerRadius", N_("Shape"), N_("Inner radius"), "",
                               N_("The radius of the hole in a disk, whose outer radius is 1."),
                               {0, 0.99F, 0.005F, {}}),
    param<&Model::tubeRadius>("tubeRadius", N_("Shape"), N_("Tube radius"), "",
                              N_("The radius of the tube of a torus, whose ring has radius 1."),
                              {0, 1, 0.005F, {}}),
    param<&Model::startAngle>("startAngle", N_("Shape"), N_("Start angle"), "",
                              N_("The angle at which a partial disk begins, clockwise from the top."),
                              {-360, 360, 0.5F, N_("deg")}),
    param<&Model::sweepAngle>("sweepAngle", N_("Shape"), N_("Sweep angle"), "",
                              N_("The angle that a partial disk "
                                 "covers."),
                              {-360, 360, 0.5F, N_("deg")}),
    param<&Model::lineWidth>("lineWidth", N_("Shape"), N_("Line width"), "glLineWidth({})",
                             N_("The width of lines in pixels, rounded to a whole number."),
                             {0.5F, 64, 0.05F, N_("pixels")}),
    param<&Model::pointSize>("pointSize", N_("Shape"), N_("Point size"), "glPointSize({})",
                             N_("The size of points in pixels, rounded to a whole number."),
                             {0.5F, 64, 0.05F, N_("pixels")}),
    param<&Model::position>("position", N_("Placement"), N_("Position"), "glTranslatef({})",
                            N_("The position of the "
                               "model's centre."),
                            {-1000, 1000, 0.01F, {}}),
    param<&Model::rotation>("rotation", N_("Placement"), N_("Rotation"), "",
                            N_("The rotation about the x, y and z axes at time 0."),
                            {-360, 360, 0.5F, N_("deg")}),
    param<&Model::rotationOrder>("rotationOrder", N_("Placement"), N_("Order"), "",
                                 N_("The order of the three rotations.")),
    param<&Model::spin>("spin", N_("Placement"), N_("Spin"), "",
                        N_("How fast each of the three rotations changes with time."),
                        {-3600, 3600, 0.5F, N_("deg/s")}),
    param<&Model::size>("size", N_("Placement"), N_("Size"), "glScalef({}, {}, {})",
                        N_("Scales the whole mesh. Textures grow with it, since they stick to the vertices."),
                        {0.01F, 100, 0.01F, {}}),
    param<&Model::scale>("scale", N_("Placement"), N_("Scale"), "glScalef({})",
                         N_("Scales each axis, in addition to the size."), {0.01F, 100, 0.01F, {}}),
    param<&Model::attachment>("attachment", N_("Placement"), N_("Attached to"), "",
                              N_("Whether the model stays in the world or moves with the camera.")),
    param<&Model::ownMaterial>("ownMaterial", N_("Material"), N_("Own material"), "",
                               N_("Whether the model has a material of its own instead of the scene's.")),
    vertexList<&Model::texCoords, 0>("texCoords0", N_("Texture coordinates"), N_("Unit 0"),
                                     "glMultiTexCoord4fv(GL_TEXTURE0, {})", texCoordHelp),
    vertexList<&Model::texCoords, 1>("texCoords1", N_("Texture coordinates"), N_("Unit 1"),
                                     "glMultiTexCoord4fv(GL_TEXTURE1, {})", texCoordHelp),
    vertexList<&Model::texCoords, 2>("texCoords2", N_("Texture coordinates"), N_("Unit 2"),
                                     "glMultiTexCoord4fv(GL_TEXTURE2, {})", texCoordHelp),
    vertexList<&Model::texCoords, 3>("texCoords3", N_("Texture coordinates"), N_("Unit 3"),
                                     "glMultiTexCoord4fv(GL_TEXTURE3, {})", texCoordHelp),
    vertexList<&Model::noTexCoord, 0>("noTexCoord0", N_("Texture coordinates"), N_("Left out for unit 0"), "",
                                      noTexCoordHelp, vertexNumbers),
    vertexList<&Model::noTexCoord, 1>("noTexCoord1", N_("Texture coordinates"), N_("Left out for unit 1"), "",
                                      noTexCoordHelp, vertexNumbers),
    vertexList<&Model::noTexCoord, 2>("noTexCoord2", N_("Texture coordinates"), N_("Left out for unit 2"), "",
                                      noTexCoordHelp, vertexNumbers),
    vertexList<&Model::noTexCoord, 3>("noTexCoord3", N_("Texture coordinates"), N_("Left out for unit 3"), "",
                                      noTexCoordHelp, vertexNumbers),
    param<&Model::pushMatrix>("pushMatrix", N_("Texture matrix"), N_("Push, pop"), "",
                              N_("glPushMatrix and glPopMatrix around the model: its texture matrix steps "
                                 "hold for it alone. If off, what is drawn later has them, too.")),
};
// The arrays of lists are one member each and have a row for each unit.
static_assert(modelRows.size() == 29 &&
              modelRows.size() + 3 == build::memberCount<Model>() - 2 + 2 * std::size_t{maxUnits});

} // namespace

const StructTable& meshTable() {
    static const StructTable table{N_("Mesh"), meshRows, {}};
    return table;
}

const StructTable& modelUnitTable() {
    static const std::array children{
        build::many<&ModelUnit::matrix>("matrix", N_("Matrix step"), matrixStepTable(), 0, maxMatrixSteps),
    };
    static_assert(children.size() == build::memberCount<ModelUnit>());
    static const StructTable table{N_("ModelUnit"), {}, children};
    return table;
}

const StructTable& modelTable() {
    static const std::array children{
        build::single<&Model::material>("material", N_("Material"), modelMaterialTable()),
        build::single<&Model::mesh>("mesh", N_("Mesh"), meshTable()),
        build::many<&Model::units>("units", N_("Unit"), modelUnitTable(), maxUnits, maxUnits),
    };
    static const StructTable table{N_("Model"), modelRows, children};
    return table;
}

} // namespace texplorer

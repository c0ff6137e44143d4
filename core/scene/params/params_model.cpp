#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::param;
using build::texCoords;

constexpr std::string_view texCoordHelp =
    "s, t, r and q of every vertex for this texture unit. An empty list takes what the mesh gives.";

constexpr std::array modelRows{
    param<&Model::shape>("shape", "Shape", "Shape", "", "Which mesh is drawn."),
    param<&Model::visible>("visible", "Shape", "Visible", "", "Whether it is drawn at all."),
    param<&Model::slices>("slices", "Shape", "Slices", "gluSphere(quadric, 1, {}, stacks)",
                          "How many strips a sphere has around its axis; other shapes ignore it.",
                          {minSlices, maxSubdivision, 0.2F, {}}),
    param<&Model::stacks>("stacks", "Shape", "Stacks", "gluSphere(quadric, 1, slices, {})",
                          "How many rings a sphere has from pole to pole; other shapes ignore it.",
                          {minStacks, maxSubdivision, 0.2F, {}}),
    param<&Model::position>("position", "Placement", "Position", "glTranslatef({})", "Where its centre is.",
                            {-1000, 1000, 0.01F, {}}),
    param<&Model::rotation>("rotation", "Placement", "Rotation", "",
                            "Turns it about the x axis, then y, then z; what it is at time 0.",
                            {-360, 360, 0.5F, "deg"}),
    param<&Model::spin>("spin", "Placement", "Spin", "",
                        "How fast each of the three rotations grows with time.",
                        {-3600, 3600, 0.5F, "deg/s"}),
    param<&Model::size>("size", "Placement", "Size", "glScalef({}, {}, {})",
                        "A factor on the whole mesh. Textures grow with it, for they stick to the vertices.",
                        {0.01F, 100, 0.01F, {}}),
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
static_assert(modelRows.size() == 12 && modelRows.size() == build::memberCount<Model>() - 1 + maxUnits);

} // namespace

const StructTable& modelTable() {
    static const StructTable table{"Model", modelRows, {}};
    return table;
}

} // namespace texplorer

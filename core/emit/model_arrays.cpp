#include "texplorer/emit/model_arrays.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// "{1.0f, 0.0f}"
std::vector<Part> braced(std::span<const float> values) {
    std::vector<Part> parts{plain("{")};
    append(parts, numbers(values));
    parts.push_back(plain("}"));
    return parts;
}

/// "{{-1.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f, 1.0f}},"
std::vector<Part> structOf(const Vertex& vertex) {
    std::vector<Part> parts{plain("{")};
    append(parts, braced({&vertex.position.x, 3}));
    parts.push_back(plain(", "));
    append(parts, braced({&vertex.normal.x, 3}));
    parts.push_back(plain(", "));
    append(parts, braced({&vertex.texCoord.x, 4}));
    parts.push_back(plain("},"));
    return parts;
}

} // namespace

int coordCount(const TexCoords& coords) {
    int count = 2;
    for (const glm::vec4 each : coords)
        count = std::max(count, each.w != 1 ? 4 : each.z != 0 ? 3 : 2);
    return count;
}

std::span<const float> firstOf(const glm::vec4& coord, int count) {
    return {&coord.x, static_cast<std::size_t>(count)};
}

ModelArrays::ModelArrays(Emission& emission, std::size_t model)
    : emission_(emission)
    , index_(model)
    , sent_(emission.scene.models[model])
    , mesh_(meshOf(*sent_))
    , variable_(fmt::format("model{}", model))
    , isWritten_(emission.models[model].isWritten) {}

TexCoords ModelArrays::coords(std::size_t unit, bool flips) const {
    TexCoords coords = effectiveTexCoords(*sent_, mesh_, static_cast<int>(unit));
    if (flips) {
        for (glm::vec4& coord : coords)
            coord.t = coord.q - coord.t;
    }
    return coords;
}

void ModelArrays::writeHeading() {
    emission_.writer.heading(fmt::format("model {}: {}", index_, nameOf(original())));
    if (leavesOutCalls(original()))
        emission_.writer.comment("a vertex without glTexCoord has the coordinates of the one before it");
}

void ModelArrays::write(const std::string& name, int columns, std::span<const glm::vec4> rows,
                        const std::string& path) {
    CodeWriter& writer = emission_.writer;
    if (!isWritten_) {
        std::vector<float> values;
        for (const glm::vec4& each : rows)
            values.insert(values.end(), &each.x, &each.x + columns);
        const std::size_t count = values.size();
        return emission_.addData("GLfloat", variable_ + name, count,
                                 Numbers{[values = std::move(values), columns] {
                                     return floatsText(values, static_cast<std::size_t>(columns) * 2);
                                 }});
    }
    writer.add(fmt::format("static const GLfloat {}{}[] = {{", variable_, name));
    writer.indent();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<Part> parts =
            numbers(firstOf(rows[i], columns), path.empty() ? path : fmt::format("{}[{}]", path, i));
        parts.push_back(plain(","));
        writer.add(std::move(parts));
    }
    writer.outdent();
    writer.add("};");
}

template<class Get>
void ModelArrays::writeEach(const std::string& name, int columns, Get get) {
    std::vector<glm::vec4> rows;
    for (const Vertex& each : mesh_.vertices)
        rows.push_back(get(each));
    write(name, columns, rows);
}

void ModelArrays::writePositions() {
    writeEach("Positions", 3, [](const Vertex& vertex) { return glm::vec4(vertex.position, 0); });
}

void ModelArrays::writeNormals() {
    writeEach("Normals", 3, [](const Vertex& vertex) { return glm::vec4(vertex.normal, 0); });
}

void ModelArrays::writeColors() {
    writeEach("Colors", 4, [](const Vertex& vertex) { return vertex.color; });
}

void ModelArrays::writeCoords(const std::string& name, std::size_t unit, bool flips) {
    const TexCoords values = coords(unit, flips);
    const bool areEdited = flips || leavesOutCalls(original());
    write(name, columns(values), values,
          areEdited ? std::string()
                    : fmt::format("{}.{}", elementOf<&Scene::models>(index_),
                                  findKey(memberId<&Model::texCoords>, unit)));
}

void ModelArrays::writeVertices() {
    CodeWriter& writer = emission_.writer;
    emission_.use(CFunction::MeshTypes);
    if (!isWritten_)
        return emission_.addData("Vertex", variable_ + "Vertices", mesh_.vertices.size(),
                                 Numbers{[vertices = mesh_.vertices] {
                                     std::string text;
                                     for (const Vertex& vertex : vertices)
                                         text += "    " + textOf(Line{structOf(vertex)}) + "\n";
                                     return text;
                                 }});
    writer.add({plain(fmt::format("static const Vertex {}Vertices[] = {{ ", variable_)),
                {Part::Kind::Comment, "/* position, normal, texture coordinates */"}});
    writer.indent();
    for (const Vertex& vertex : mesh_.vertices)
        writer.add(structOf(vertex));
    writer.outdent();
    writer.add("};");
}

void ModelArrays::writeIndices(const std::vector<std::uint32_t>& indices) {
    if (!isWritten_)
        return emission_.addData("GLuint", variable_ + "Indices", indices.size(),
                                 Numbers{[indices] { return indicesText(indices); }});
    constexpr std::size_t columns = 18;
    CodeWriter& writer = emission_.writer;
    const std::string head = fmt::format("static const GLuint {}Indices[] = {{", variable_);
    if (indices.size() <= columns)
        return writer.add(fmt::format("{}{}}};", head, fmt::join(indices, ", ")));
    writer.add(head);
    writer.indent();
    for (auto row = indices.begin(); row != indices.end();) {
        const auto end = row + std::min<std::ptrdiff_t>(columns, indices.end() - row);
        writer.add(fmt::format("{},", fmt::join(row, end, ", ")));
        row = end;
    }
    writer.outdent();
    writer.add("};");
}

void ModelArrays::writeEmbossing(std::size_t unit) {
    const TexCoords given = coords(unit);
    write(fmt::format("GivenTexCoords{}", unit), 4, given);
    std::vector<glm::vec4> directions;
    for (const Tangents& each : tangentsOf(mesh_, given))
        directions.insert(directions.end(), {glm::vec4(each.s, 0), glm::vec4(each.t, 0)});
    write(fmt::format("Tangents{}", unit), 3, directions);
    emission_.atStart.add({plain(fmt::format("static GLfloat {}EmbossedTexCoords{}[{}]; ", variable_, unit,
                                             4 * mesh_.vertices.size())),
                           {Part::Kind::Comment, "/* in every frame moved towards the light */"}});
    emission_.use(CFunction::LightInModel);
    emission_.use(CFunction::Emboss);
}

void ModelArrays::writeEmboss(std::size_t pass, std::size_t unit, const std::string& modelView) {
    const Emboss& emboss = emission_.scene.passes[pass].units[unit].emboss;
    const glm::vec4& light = emission_.scene.light.position;
    CodeWriter& writer = emission_.writer;
    writer.add("GLfloat light[4];");
    std::vector<Part> parts{plain(fmt::format("lightInModel({}, (const GLfloat[]){{", modelView))};
    append(parts, numbers({&light.x, 4}, pathOf<&Scene::light, &Light::position>()));
    parts.push_back(plain(fmt::format("}}, {}, light);", emboss.carrier == LightCarrier::Transpose ? 1 : 0)));
    writer.add(std::move(parts));
    writer.add({plain(fmt::format("emboss({0}, {1}Positions, {1}GivenTexCoords{2}, {1}Tangents{2}, light, ",
                                  mesh_.vertices.size(), variable_, unit)),
                number(emboss.depth, unitPath(pass, unit, {keyOf<&Unit::emboss>(), keyOf<&Emboss::depth>()})),
                plain(fmt::format(", {}EmbossedTexCoords{});", variable_, unit))});
}

} // namespace texplorer::emit

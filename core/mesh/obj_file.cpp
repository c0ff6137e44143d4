#include "texplorer/mesh/obj_file.h"

#include "texplorer/mesh/obj_lines.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <span>
#include <sstream>
#include <string_view>
#include <tiny_obj_loader.h>
#include <unordered_map>
#include <utility>

namespace texplorer {
namespace {

/// A vertex of a polygon: indices from 0; -1: none.
struct Corner {
    int position = -1;
    int texCoord = -1;
    int normal = -1;

    bool operator==(const Corner&) const = default;
};

struct CornerHash {
    std::size_t operator()(const Corner& corner) const {
        std::uint64_t mixed = static_cast<std::uint32_t>(corner.position);
        for (const int each : {corner.texCoord, corner.normal})
            mixed = mixed * 0x9E3779B97F4A7C15U + static_cast<std::uint32_t>(each);
        return static_cast<std::size_t>(mixed ^ (mixed >> 32));
    }
};

using Triangle = std::array<Corner, 3>;

/// What the lines of a file say, in their order.
struct Lines {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> texCoords;
    std::vector<glm::vec3> normals;
    std::map<std::pair<std::string, std::string>, std::size_t> partOf; ///< by name and material
    std::vector<std::pair<std::string, std::string>> parts; ///< in the order of their first polygon
    std::vector<std::vector<Triangle>> triangles;           ///< of each part
    std::vector<tinyobj::material_t> materials;
    std::string name;
    std::string material;
    std::vector<int> polygonLines; ///< numbers of lines in the file
    std::size_t polygons = 0;
    Sentence problem;
};

Lines& linesOf(void* user) {
    return *static_cast<Lines*>(user);
}

/// From OBJ's index, which begins at 1, or at -1 from the end; 0: none. Empty: there is no such entry.
std::optional<int> indexOf(int given, std::size_t count) {
    if (given == 0)
        return -1;
    const std::int64_t index = given > 0 ? std::int64_t{given} - 1 : static_cast<std::int64_t>(count) + given;
    return index >= 0 && std::cmp_less(index, count) ? std::optional(static_cast<int>(index)) : std::nullopt;
}

std::optional<Corner> cornerOf(Lines& lines, const tinyobj::index_t& given) {
    const auto position = indexOf(given.vertex_index, lines.positions.size());
    const auto texCoord = indexOf(given.texcoord_index, lines.texCoords.size());
    const auto normal = indexOf(given.normal_index, lines.normals.size());
    if (position && *position >= 0 && texCoord && normal)
        return Corner{*position, *texCoord, *normal};
    const auto problem = [&](std::string_view what, int number, std::size_t count) {
        const int line = lines.polygonLines[lines.polygons - 1];
        lines.problem = count == 0 ? Sentence("line {0}: expected {1} {2} in an earlier line, found no {1}",
                                              line, ProperName{what}, number)
                                   : Sentence("line {0}: expected {1} from 1 to {2}, found {3}", line,
                                              ProperName{what}, count, number);
    };
    if (!position || *position < 0)
        problem("v", given.vertex_index, lines.positions.size());
    else if (!texCoord)
        problem("vt", given.texcoord_index, lines.texCoords.size());
    else
        problem("vn", given.normal_index, lines.normals.size());
    return std::nullopt;
}

void takePolygon(Lines& lines, std::span<const tinyobj::index_t> given) {
    ++lines.polygons;
    if (!lines.problem.empty() || given.size() < 3)
        return;
    const auto [part, isNew] = lines.partOf.try_emplace({lines.name, lines.material}, lines.parts.size());
    if (isNew) {
        lines.parts.push_back(part->first);
        lines.triangles.emplace_back();
    }
    std::vector<Triangle>& triangles = lines.triangles[part->second];
    const std::optional<Corner> first = cornerOf(lines, given[0]);
    std::optional<Corner> last = cornerOf(lines, given[1]);
    for (std::size_t i = 2; i < given.size() && first && last; ++i) {
        const std::optional<Corner> next = cornerOf(lines, given[i]);
        if (next)
            triangles.push_back({*first, *last, *next});
        last = next;
    }
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* user, float x, float y, float z, float) {
        linesOf(user).positions.emplace_back(x, y, z);
    };
    calls.normal_cb = [](void* user, float x, float y, float z) {
        linesOf(user).normals.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* user, float x, float y, float) {
        linesOf(user).texCoords.emplace_back(x, y);
    };
    calls.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        takePolygon(linesOf(user), {indices, static_cast<std::size_t>(count)});
    };
    calls.usemtl_cb = [](void* user, const char* name, int) { linesOf(user).material = name; };
    calls.group_cb = [](void* user, const char** names, int count) {
        linesOf(user).name = count > 0 ? names[0] : "";
    };
    calls.object_cb = [](void* user, const char* name) { linesOf(user).name = name; };
    return calls;
}

/// The library makes materials without Kd black.
void whiten(const std::string& text, std::vector<tinyobj::material_t>& materials) {
    std::set<std::string> colored;
    std::istringstream lines(text);
    std::string name;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first == "newmtl")
            words >> name;
        else if (first == "Kd")
            colored.insert(name);
    }
    for (tinyobj::material_t& material : materials) {
        if (!colored.contains(material.name))
            std::ranges::fill(material.diffuse, 1.0F);
    }
}

/// The path of an image that a library names.
std::string besideLibrary(std::string library, std::string image) {
    for (std::string* name : {&library, &image})
        std::ranges::replace(*name, '\\', '/');
    return (std::filesystem::path(library).parent_path() / image).generic_string();
}

/// The materials of all libraries that can be read.
void readMaterials(const std::vector<std::string>& names, const ReadMaterials& read, Lines& lines,
                   std::vector<Sentence>& notes) {
    for (const std::string& name : names) {
        const std::optional<std::string> text = read(name);
        if (!text)
            notes.push_back(Sentence("the material library {0} can't be read: drawn without its materials",
                                     ProperName{name}));
        if (!text || text->empty()) // of no text the parser makes a material
            continue;
        std::vector<tinyobj::material_t> materials;
        std::istringstream stream(*text);
        std::map<std::string, int> numbers;
        std::string warning;
        std::string error;
        tinyobj::LoadMtl(&numbers, &materials, &stream, &warning, &error);
        whiten(*text, materials);
        for (tinyobj::material_t& material : materials) {
            if (!material.diffuse_texname.empty())
                material.diffuse_texname = besideLibrary(name, material.diffuse_texname);
            lines.materials.push_back(std::move(material));
        }
    }
}

ObjMaterial materialOf(const Lines& lines, const std::string& name) {
    const auto found = std::ranges::find(lines.materials, name, &tinyobj::material_t::name);
    ObjMaterial material{name};
    if (found == lines.materials.end())
        return material;
    const auto share = [](float value) { return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1; };
    material.color = {share(found->diffuse[0]), share(found->diffuse[1]), share(found->diffuse[2]),
                      share(found->dissolve)};
    material.image = found->diffuse_texname;
    return material;
}

/// The sum of the triangles' normals at each position, as long as twice their areas.
std::vector<glm::dvec3> meanNormals(const Lines& lines) {
    std::vector<glm::dvec3> sums(lines.positions.size(), glm::dvec3(0));
    const auto at = [&](const Corner& corner) { return static_cast<std::size_t>(corner.position); };
    for (const std::vector<Triangle>& part : lines.triangles) {
        for (const auto& [a, b, c] : part) {
            const glm::dvec3 origin(lines.positions[at(a)]);
            const glm::dvec3 normal = glm::cross(glm::dvec3(lines.positions[at(b)]) - origin,
                                                 glm::dvec3(lines.positions[at(c)]) - origin);
            for (const Corner& corner : {a, b, c})
                sums[at(corner)] += normal;
        }
    }
    return sums;
}

/// A unit vector; +z where there is no direction.
glm::vec3 unitOf(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return std::isfinite(length) && length > 0 ? glm::vec3(vector / length) : glm::vec3(0, 0, 1);
}

/// Makes the mesh of a part.
class PartMaker {
public:
    PartMaker(const Lines& lines, const std::vector<glm::dvec3>& means, ObjFile& out)
        : lines_(lines)
        , means_(means)
        , out_(out) {}

    Result<void> add(const std::string& name, int material,
                     std::span<const std::vector<Triangle>* const> lists) {
        part_ = {name, material, {}};
        numbers_.clear();
        hasTexCoords_ = false;
        for (const std::vector<Triangle>* list : lists) {
            for (const Triangle& triangle : *list) {
                for (const Corner& corner : triangle)
                    part_.mesh.indices.push_back(vertexOf(corner));
                const std::size_t vertices = part_.mesh.positions.size();
                const std::size_t indices = part_.mesh.indices.size();
                if (vertices > maxFileVertices || indices > maxFileIndices)
                    return fail(ErrorCode::TooLarge,
                                Sentence("a part has {0} vertices and {1} corners of triangles; at most {2} "
                                         "and {3} are read",
                                         vertices, indices, maxFileVertices, maxFileIndices));
            }
        }
        if (!hasTexCoords_)
            part_.mesh.texCoords.clear();
        if (!part_.mesh.indices.empty())
            out_.parts.push_back(std::move(part_));
        return {};
    }

private:
    int vertexOf(const Corner& corner) {
        MeshData& mesh = part_.mesh;
        const auto [found, isNew] = numbers_.try_emplace(corner, static_cast<int>(mesh.positions.size()));
        if (!isNew)
            return found->second;
        const auto position = static_cast<std::size_t>(corner.position);
        mesh.positions.push_back(lines_.positions[position]);
        mesh.normals.push_back(
            unitOf(corner.normal < 0 ? means_[position]
                                     : glm::dvec3(lines_.normals[static_cast<std::size_t>(corner.normal)])));
        hasTexCoords_ = hasTexCoords_ || corner.texCoord >= 0;
        const glm::vec2 st =
            corner.texCoord < 0 ? glm::vec2(0) : lines_.texCoords[static_cast<std::size_t>(corner.texCoord)];
        mesh.texCoords.emplace_back(st, 0, 1);
        return found->second;
    }

    const Lines& lines_;
    const std::vector<glm::dvec3>& means_;
    ObjFile& out_;
    ObjPart part_;
    std::unordered_map<Corner, int, CornerHash> numbers_;
    bool hasTexCoords_ = false;
};

/// The number of a material, which is added where it is new.
int materialNumber(ObjFile& out, const Lines& lines, const std::string& name) {
    const auto found = std::ranges::find(out.materials, name, &ObjMaterial::name);
    if (found != out.materials.end())
        return static_cast<int>(found - out.materials.begin());
    if (!name.empty() && !lines.materials.empty() &&
        std::ranges::find(lines.materials, name, &tinyobj::material_t::name) == lines.materials.end())
        out.notes.push_back(Sentence("the material {0} is in no library", ProperName{name}));
    out.materials.push_back(materialOf(lines, name));
    return static_cast<int>(out.materials.size()) - 1;
}

/// One part for each object and material, or for each material.
Result<void> makeParts(ObjFile& out, const Lines& lines, std::size_t maxParts) {
    std::map<std::string, std::vector<const std::vector<Triangle>*>> ofMaterial;
    for (std::size_t i = 0; i < lines.parts.size(); ++i)
        ofMaterial[lines.parts[i].second].push_back(&lines.triangles[i]);
    if (ofMaterial.size() > maxParts)
        return fail(ErrorCode::TooLarge,
                    Sentence("it uses {0} materials, each of which needs a model; a scene has at most {1}",
                             ofMaterial.size(), maxParts));
    const std::vector<glm::dvec3> means = meanNormals(lines);
    PartMaker maker(lines, means, out);
    if (lines.parts.size() <= maxParts) {
        for (std::size_t i = 0; i < lines.parts.size(); ++i) {
            const std::array lists{&lines.triangles[i]};
            if (Result<void> made =
                    maker.add(lines.parts[i].first, materialNumber(out, lines, lines.parts[i].second), lists);
                !made)
                return made;
        }
        return {};
    }
    for (const auto& [material, lists] : ofMaterial)
        if (Result<void> made = maker.add(material, materialNumber(out, lines, material), lists); !made)
            return made;
    out.notes.push_back(Sentence("{0} objects are merged by their materials", lines.parts.size()));
    return {};
}

} // namespace

Result<ObjFile> decodeObj(ByteView file, const ReadMaterials& materials, std::size_t maxParts) {
    ObjFile out;
    Lines lines;
    Result<ObjLines> checked = checkedObjLines(file);
    if (!checked)
        return fail(checked.error());
    if (checked->polygonLines.empty())
        return fail(ErrorCode::Malformed, "expected polygons (lines that begin with f), found none");
    try {
        lines.polygonLines = std::move(checked->polygonLines);
        std::istringstream stream(std::move(checked->text));
        std::string warning;
        std::string error;
        tinyobj::LoadObjWithCallback(stream, callbacks(), &lines, nullptr, &warning, &error);
        if (!lines.problem.empty())
            return fail(ErrorCode::Malformed, lines.problem);
        readMaterials(checked->libraries, materials, lines, out.notes);
        if (Result<void> made = makeParts(out, lines, maxParts); !made)
            return fail(made.error());
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for its vertices");
    }
    return out;
}

} // namespace texplorer

#include "texplorer/emit/c_functions.h"

#include "texplorer/emit/code_writer.h"
#include "texplorer/emit/piece_files.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace texplorer::emit {
namespace {

struct NamedPiece {
    CFunction function;
    std::string_view file;
};

constexpr std::array namedPieces{
    NamedPiece{CFunction::MeshTypes, "mesh.c"},
    NamedPiece{CFunction::Pi, "pi.c"},
    NamedPiece{CFunction::Checkerboard, "checkerboard.c"},
    NamedPiece{CFunction::Gradient, "gradient.c"},
    NamedPiece{CFunction::Fill, "fill.c"},
    NamedPiece{CFunction::Unpack, "unpack.c"},
    NamedPiece{CFunction::Halve, "halve.c"},
    NamedPiece{CFunction::ReadBmp, "read_bmp.c"},
    NamedPiece{CFunction::ReadTga, "read_tga.c"},
    NamedPiece{CFunction::ReadDds, "read_dds.c"},
    NamedPiece{CFunction::Grid, "grid.c"},
    NamedPiece{CFunction::Ring, "ring.c"},
    NamedPiece{CFunction::Sphere, "sphere.c"},
    NamedPiece{CFunction::Cylinder, "cylinder.c"},
    NamedPiece{CFunction::Torus, "torus.c"},
    NamedPiece{CFunction::Disk, "disk.c"},
    NamedPiece{CFunction::Perspective, "perspective.c"},
    NamedPiece{CFunction::LightInModel, "light_in_model.c"},
    NamedPiece{CFunction::Emboss, "emboss.c"},
    NamedPiece{CFunction::Matrices, "matrix.c"},
    NamedPiece{CFunction::Degree, "degree.c"},
    NamedPiece{CFunction::Identity, "identity.c"},
    NamedPiece{CFunction::Translation, "translation.c"},
    NamedPiece{CFunction::Rotation, "rotation.c"},
    NamedPiece{CFunction::Scaling, "scaling.c"},
    NamedPiece{CFunction::Frustum, "perspective_matrix.c"},
    NamedPiece{CFunction::Orthographic, "orthographic_matrix.c"},
    NamedPiece{CFunction::FloatProduct, "multiply_floats.c"},
    NamedPiece{CFunction::SetMatrix, "set_matrix.c"},
    NamedPiece{CFunction::SetNormalMatrix, "set_normal_matrix.c"},
    NamedPiece{CFunction::NewProgram, "new_program.c"},
    NamedPiece{CFunction::Buffers, "new_buffer.c"},
};

/// Each row at the place of its function.
static_assert(std::ranges::equal(namedPieces, namedPieces, [at = 0](const auto& each, const auto&) mutable {
    return static_cast<int>(each.function) == at++;
}));

struct Piece {
    std::string_view text;                   ///< below what it includes
    std::vector<CFunction> callees{};        ///< whose files it includes
    std::vector<std::string_view> headers{}; ///< of C's library
};

std::string_view textOfFile(std::string_view name) {
    const auto& files = cFunctionFiles();
    const auto found = std::ranges::find(files, name, &PieceFile::name);
    assert(found != files.end());
    return found->text;
}

Piece parsed(std::string_view text) {
    constexpr std::string_view word = "#include ";
    Piece piece;
    while (text.starts_with(word) || text.starts_with('\n')) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(line.size() + 1);
        if (line.empty())
            continue;
        const std::string_view name = line.substr(word.size() + 1, line.size() - word.size() - 2);
        const auto callee = std::ranges::find(namedPieces, name, &NamedPiece::file);
        if (callee != namedPieces.end())
            piece.callees.push_back(callee->function);
        else if (line.ends_with('>'))
            piece.headers.push_back(name);
    }
    piece.text = text;
    return piece;
}

const Piece& pieceOf(CFunction function) {
    static const std::vector<Piece> all = [] {
        std::vector<Piece> pieces;
        for (const NamedPiece& each : namedPieces)
            pieces.push_back(parsed(textOfFile(each.file)));
        return pieces;
    }();
    return all.at(static_cast<std::size_t>(function));
}

} // namespace

void addWithCallees(std::set<CFunction>& functions, CFunction function) {
    functions.insert(function);
    for (const CFunction callee : pieceOf(function).callees)
        addWithCallees(functions, callee);
}

std::vector<Line> linesOf(const std::set<CFunction>& functions) {
    std::vector<Line> lines;
    for (const CFunction function : functions) {
        for (Line& line : linesOf(pieceOf(function).text))
            lines.push_back(std::move(line));
    }
    return lines;
}

std::set<std::string_view> headersOf(const std::set<CFunction>& functions) {
    std::set<std::string_view> headers;
    for (const CFunction function : functions) {
        const Piece& piece = pieceOf(function);
        headers.insert(piece.headers.begin(), piece.headers.end());
    }
    return headers;
}

std::string_view openGlHeaders() {
    return textOfFile("gl.h");
}

} // namespace texplorer::emit

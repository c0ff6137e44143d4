# Run as a script: writes the files of shaders/ into a source, so that an installed program needs none.
#   cmake -DOUT=… -DFOLDER=… -DNAMES=a.glsl,b.glsl -P EmbedShaders.cmake
string(REPLACE "," ";" names "${NAMES}")
set(text "// Made from shaders/ by cmake/EmbedShaders.cmake.\n#include \"app/render/shader_pieces.h\"\n\n")
string(APPEND text "namespace texplorer::render {\n\nconst std::vector<ShaderFile>& embeddedShaderFiles() {\n")
string(APPEND text "    static const std::vector<ShaderFile> files{\n")
foreach(name IN LISTS names)
    file(READ "${FOLDER}/${name}" content)
    string(APPEND text "        {\"${name}\", R\"glsl(${content})glsl\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n} // namespace texplorer::render\n")
file(WRITE "${OUT}" "${text}")

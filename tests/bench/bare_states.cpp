// The peer of many shots in one call: the same 36 pictures drawn and read back in one OSMesa context by plain
// OpenGL, nothing encoded and nothing written. With a folder, what was read is left there, NUMBER.rgba.

#include "tests/bench/bare_scene.h"
#include "tests/bench/shot_states.h"
#include "texplorer/files/file_io.h"

#include <GL/osmesa.h>

#include <filesystem>
#include <string>

int main(int argc, char** argv) {
    using namespace texplorer;
    std::vector<std::byte> unseen(4);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    if (!context || !OSMesaMakeCurrent(context, unseen.data(), GL_UNSIGNED_BYTE, 1, 1))
        return 1;
    const bench::BareScene scene(bench::statesExtent, bench::statesExtent);
    bool good = true;
    int number = 0;
    bench::eachState([&](const EnumRow& filter, const EnumRow& mode) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter.value));
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode.value));
        scene.draw();
        const Image picture = scene.read();
        const std::string name = std::to_string(++number) + ".rgba";
        if (argc > 1 && !writeFileAtomically(std::filesystem::path(argv[1]) / name, picture.pixels))
            good = false;
    });
    good = good && glGetError() == GL_NO_ERROR;
    OSMesaDestroyContext(context);
    return good ? 0 : 1;
}

#include "tests/support/sample_jpegs.h"

#include <turbojpeg.h>
#include <utility>

namespace texplorer::test {

std::vector<Bytes> sampleJpegs() {
    constexpr int extent = 20; // more than one block of 16 x 16
    std::vector<unsigned char> pixels;
    for (int i = 0; i < extent * extent * 3; ++i)
        pixels.push_back(static_cast<unsigned char>(i * i % 251));
    std::vector<Bytes> files;
    tjhandle handle = tjInitCompress();
    for (const auto& [subsampling, flags] : {std::pair{TJSAMP_444, 0},
                                             {TJSAMP_422, 0},
                                             {TJSAMP_420, 0},
                                             {TJSAMP_440, 0},
                                             {TJSAMP_GRAY, 0},
                                             {TJSAMP_420, TJFLAG_PROGRESSIVE}}) {
        unsigned char* file = nullptr;
        unsigned long size = 0;
        if (tjCompress2(handle, pixels.data(), extent, 0, extent, TJPF_RGB, &file, &size, subsampling, 60,
                        flags) == 0) {
            const auto* bytes = reinterpret_cast<const std::byte*>(file);
            files.emplace_back(bytes, bytes + size);
        }
        tjFree(file);
    }
    tjDestroy(handle);
    return files;
}

} // namespace texplorer::test

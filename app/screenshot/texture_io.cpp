#include "app/screenshot/texture_io.h"

#include "core/base/file_io.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace texplorer::screenshot {
namespace {

volatile std::sig_atomic_t signalled = 0;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

Result<TextureImage> readTexture(const std::string& path) {
    const Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    Result<TextureImage> texture = decodeTexture(*bytes);
    if (!texture)
        return fail(texture.error().code, texture.error().message, path);
    return texture;
}

Result<const CodecRow*> writerFor(const std::string& path) {
    const CodecRow* codec = codecForExtension(path);
    if (codec && codec->encode)
        return codec;
    std::string known;
    for (const CodecRow& row : codecRows())
        if (row.encode)
            known.append(known.empty() ? "" : ", ").append(extensionsOf(row).front());
    return fail(ErrorCode::Unsupported,
                "expected a name that ends in one of " + known + ", found \"" + path + "\"");
}

Result<void> writeTexture(const std::string& path, const TextureImage& texture, const WriteOptions& options) {
    const Result<const CodecRow*> codec = writerFor(path);
    if (!codec)
        return fail(codec.error());
    const Result<Bytes> bytes = (*codec)->encode(texture, options);
    if (!bytes)
        return fail(bytes.error().code, bytes.error().message, path);
    return writeFileAtomically(path, *bytes);
}

LongWork::LongWork(std::string what)
    : what_(std::move(what))
    , start_(seconds())
    , terminal_(isatty(STDERR_FILENO) == 1) {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { signalled = 1; });
}

LongWork::~LongWork() {
    finish();
}

void LongWork::finish() {
    if (shownPercent_ >= 0)
        std::fprintf(stderr, "\r\033[K");
    shownPercent_ = -1;
    terminal_ = false;
}

void LongWork::report(float done) {
    if (signalled)
        stop_.request_stop();
    if (!terminal_ || seconds() - start_ < 1)
        return;
    const int percent = static_cast<int>(done * 100);
    if (shownPercent_.exchange(percent) != percent)
        std::fprintf(stderr, "\r%s: %d %%", what_.c_str(), percent);
}

} // namespace texplorer::screenshot

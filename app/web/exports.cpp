// The functions that the page calls (page/texplorer.mjs). A text or a file is given in memory that `allocate`
// has returned and that the called function frees.

#include "app/web/browser.h"
#include "app/web/program.h"
#include "app/web/sent_sentences.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace {

using namespace texplorer;

std::unique_ptr<web::Program> program; // one per page
std::vector<stage::NamedFile> given;

stage::Modifiers modifiersOf(unsigned bits) {
    return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0, (bits & 8U) != 0};
}

stage::Surface surfaceOf(int width, int height, int pixelWidth, int pixelHeight, float scale, bool visible) {
    return {{width, height}, {pixelWidth, pixelHeight}, scale, visible};
}

std::string takeText(char* text, std::size_t length) {
    std::string taken(text, length);
    std::free(text);
    return taken;
}

/// A file; nothing if there is not enough memory, which the user is told.
std::optional<Bytes> takeBytes(const std::string& name, std::byte* bytes, std::size_t count) {
    std::optional<Bytes> taken;
    try {
        taken.emplace(bytes, bytes + count);
    } catch (const std::bad_alloc&) {
        program->say(Sentence("There is not enough memory for {0}.", ProperName{name}));
    }
    std::free(bytes);
    return taken;
}

} // namespace

TEXPLORER_EXPORT(allocate) void* allocateForPage(std::size_t bytes) {
    return std::malloc(std::max<std::size_t>(1, bytes)); // nullptr: there is not enough memory
}

/// Frees what `allocate` has returned and no function has taken over.
TEXPLORER_EXPORT(release) void release(void* memory) {
    std::free(memory);
}

TEXPLORER_EXPORT(start)
void start(int width, int height, int pixelWidth, int pixelHeight, float scale, bool hasFingers, char* page,
           std::size_t length) {
    program = std::make_unique<web::Program>(surfaceOf(width, height, pixelWidth, pixelHeight, scale, true),
                                             hasFingers, takeText(page, length));
}

/// What follows # in the page's address.
TEXPLORER_EXPORT(openAddress) void openAddress(char* address, std::size_t length) {
    program->openAddress(takeText(address, length));
}

TEXPLORER_EXPORT(step) double step() {
    return program->step();
}

TEXPLORER_EXPORT(store) void store() {
    program->store();
}

TEXPLORER_EXPORT(pointerMoved) void pointerMoved(float x, float y) {
    program->happened(stage::PointerMoved{x, y});
}

TEXPLORER_EXPORT(pointerLeft) void pointerLeft() {
    program->happened(stage::PointerLeft{});
}

TEXPLORER_EXPORT(buttonChanged) void buttonChanged(int button, bool down, unsigned modifiers) {
    program->happened(stage::ButtonChanged{button, down, modifiersOf(modifiers)});
}

TEXPLORER_EXPORT(wheelTurned) void wheelTurned(float x, float y, unsigned modifiers) {
    program->happened(stage::WheelTurned{x, y, modifiersOf(modifiers)});
}

TEXPLORER_EXPORT(keyChanged) void keyChanged(int kind, int code, unsigned modifiers) {
    program->happened(
        stage::KeyChanged{static_cast<stage::KeyChanged::Kind>(kind), code, modifiersOf(modifiers)});
}

TEXPLORER_EXPORT(textEntered) void textEntered(std::uint32_t character) {
    program->happened(stage::TextEntered{character});
}

/// A message from the page around this one (app/stage/messages.h).
TEXPLORER_EXPORT(receive) void receive(char* message, std::size_t length) {
    program->receive(takeText(message, length));
}

TEXPLORER_EXPORT(scrolledByNotch) float scrolledByNotch() {
    return web::Program::scrolledByNotch();
}

TEXPLORER_EXPORT(focusChanged) void focusChanged(bool focused) {
    program->happened(stage::FocusChanged{focused});
}

TEXPLORER_EXPORT(surfaceChanged)
void surfaceChanged(int width, int height, int pixelWidth, int pixelHeight, float scale, bool visible) {
    program->happened(
        stage::SurfaceChanged{surfaceOf(width, height, pixelWidth, pixelHeight, scale, visible)});
}

TEXPLORER_EXPORT(refresh) void refresh() {
    program->happened(stage::Refresh{});
}

TEXPLORER_EXPORT(fullScreenChanged) void fullScreenChanged(bool fills) {
    program->fullScreenChanged(fills);
}

TEXPLORER_EXPORT(contextRestored) void contextRestored() {
    program->contextRestored();
}

TEXPLORER_EXPORT(clipboardChanged) void clipboardChanged(char* text, std::size_t length) {
    program->setClipboard(takeText(text, length));
}

/// One of the files of the next `filesGiven`.
TEXPLORER_EXPORT(addFile)
void addFile(char* name, std::size_t nameLength, std::byte* bytes, std::size_t byteCount) {
    std::string text = takeText(name, nameLength);
    if (std::optional<Bytes> taken = takeBytes(text, bytes, byteCount))
        given.push_back({std::move(text), *std::move(taken)});
}

/// A given file has the content `now` in place of `before`. Returns whether the document has it.
TEXPLORER_EXPORT(fileChanged)
bool fileChanged(char* name, std::size_t nameLength, std::byte* before, std::size_t countBefore,
                 std::byte* now, std::size_t countNow) {
    const std::string text = takeText(name, nameLength);
    const std::optional<Bytes> old = takeBytes(text, before, countBefore);
    const std::optional<Bytes> changed = takeBytes(text, now, countNow);
    return old && changed && program->fileChanged(*old, *changed);
}

TEXPLORER_EXPORT(filesGiven) void filesGiven(bool answers) {
    program->filesGiven(std::exchange(given, {}), answers);
}

/// The left, top, right and bottom (`edge` 0 to 3) of a widget; -1: there is none. See Program::place.
TEXPLORER_EXPORT(placeOf) float placeOf(char* name, std::size_t length, int edge) {
    const std::optional<ui::WidgetPlaces::Item> place = program->place(takeText(name, length));
    return place ? std::array{place->left, place->top, place->right, place->bottom}.at(
                       static_cast<std::size_t>(edge))
                 : -1;
}

/// A worker has drawn: width * height * 4 bytes, bottom row first, 0 bytes if there is no picture; nullptr if
/// the page has no memory for them.
TEXPLORER_EXPORT(takePicture)
void takePicture(unsigned worker, std::byte* pixels, std::size_t byteCount, int width, int height,
                 double milliseconds, char* problems, std::size_t length) {
    const std::string said = takeText(problems, length);
    try {
        if (!pixels)
            throw std::bad_alloc();
        Image image;
        if (byteCount > 0)
            image = {PixelFormat::Rgba8, width, height, 1, Bytes(pixels, pixels + byteCount)};
        program->takePicture(worker, std::move(image), milliseconds, web::receivedSentences(said));
    } catch (const std::bad_alloc&) {
        program->workerEnded(worker, N_("not enough memory for the picture"));
    }
    std::free(pixels);
}

/// A worker has made a file, or not: `sentences` has a remark or the reason. `bytes` are nullptr if the page
/// has no memory for them.
TEXPLORER_EXPORT(takeFile)
void takeFile(unsigned worker, bool made, std::byte* bytes, std::size_t byteCount, char* sentences,
              std::size_t length) {
    const Sentence said = web::receivedSentences(takeText(sentences, length)).at(0);
    try {
        if (!bytes)
            throw std::bad_alloc();
        if (made)
            program->takeFile(worker, ui::MadeFile{Bytes(bytes, bytes + byteCount), said});
        else
            program->workerEnded(worker, said);
    } catch (const std::bad_alloc&) {
        program->workerEnded(worker, N_("not enough memory for it"));
    }
    std::free(bytes);
}

TEXPLORER_EXPORT(fileProgress) void fileProgress(unsigned worker, float share) {
    program->fileProgress(worker, share);
}

TEXPLORER_EXPORT(workerEnded) void workerEnded(unsigned worker, char* reason, std::size_t length) {
    program->workerEnded(worker, takeText(reason, length));
}

/// The page's own controls of a lesson. Counted from 0.
TEXPLORER_EXPORT(answer) void answer(std::size_t number) {
    program->answer(number);
}

TEXPLORER_EXPORT(goToStep) void goToStep(std::size_t step) {
    program->goToStep(step);
}

/// The page could not read a file that the user has given.
TEXPLORER_EXPORT(fileRefused) void fileRefused(char* name, std::size_t length) {
    program->say(Sentence("{0} can't be read.", ProperName{takeText(name, length)}));
}

/// The page can't keep what the program writes.
TEXPLORER_EXPORT(storageFailed) void storageFailed(char* reason, std::size_t length) {
    program->say(
        Sentence("The browser does not store unsaved work and settings: {0}.", takeText(reason, length)));
}

TEXPLORER_EXPORT(clipboardRefused) void clipboardRefused() {
    program->say(N_("The browser does not let the page copy; nothing is in the clipboard."));
}

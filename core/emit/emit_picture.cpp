// Textures that show what passes draw: they are drawn into, or copied from the window, in every frame.

#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/gl/core_format.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

std::string pathOf(const TextureObject& object, const std::string& key) {
    return fmt::format("{}.{}", elementOf<&Scene::textures>(object.texture), key);
}

const Texture& textureOf(const Emission& emission, std::size_t object) {
    return emission.scene.textures[emission.objects[object].texture];
}

Part sizeOf(const Emission& emission, std::size_t object) {
    return whole(textureOf(emission, object).pictureSize,
                 pathOf(emission.objects[object], keyOf<&Texture::pictureSize>()));
}

Part formatOf(const Emission& emission, std::size_t object) {
    const InternalFormat format = textureOf(emission, object).internalFormat;
    return choice(emission.isCore ? coreFormatOf(format).name : rowOf(format).name,
                  pathOf(emission.objects[object], keyOf<&Texture::internalFormat>()));
}

/// Whether a pass reads the texture that it draws into.
bool readsItself(const Scene& scene, const Texture& texture) {
    return std::ranges::any_of(unfinishedReads(scene), [&](const UnfinishedRead& read) {
        return scene.passes[read.pass].picture == texture.picture &&
               scene.textures[read.texture].picture == texture.picture;
    });
}

/// What a program does not do with a picture: a parameter that is not as in a new texture.
const std::string* otherParameter(const Texture& texture) {
    static const Texture initial;
    if (!texture.preparation.empty())
        return &keyOf<&Texture::preparation>();
    if (!texture.subimages.empty())
        return &keyOf<&Texture::subimages>();
    if (texture.transparency != initial.transparency)
        return &keyOf<&Texture::transparency>();
    if (texture.border != 0)
        return &keyOf<&Texture::border>();
    if (texture.compression == Compression::Driver || texture.compression == Compression::Cached)
        return &keyOf<&Texture::compression>();
    if (texture.npot == NpotPolicy::PowerOfTwo)
        return &keyOf<&Texture::npot>();
    return nullptr;
}

bool isRenderable(InternalFormat format) {
    const BaseFormat base = baseFormat(format);
    return !isDepth(format) && !isGenericCompressed(format) && !isSrgb(format) &&
           (base == BaseFormat::Rgb || base == BaseFormat::Rgba);
}

Result<void> checkPicture(const Scene& scene, const TextureObject& object) {
    const Texture& texture = scene.textures[object.texture];
    const std::string path = elementOf<&Scene::textures>(object.texture);
    if (object.target != Target::Texture2D)
        return fail(ErrorCode::Unsupported,
                    Sentence("programs support pictures of passes for {0}, not for {1}",
                             rowOf(Target::Texture2D).name, rowOf(object.target).name),
                    path);
    if (const std::string* key = otherParameter(texture))
        return refuse("programs show pictures of passes as they are drawn, without this", path, *key);
    if (texture.mipmaps != MipPolicy::None && texture.mipmaps != MipPolicy::GenerateMipmap)
        return refuse(Sentence("programs have mipmaps of a picture of passes from {0} or none",
                               rowOf(MipPolicy::GenerateMipmap).name),
                      path, keyOf<&Texture::mipmaps>());
    if (texture.pictureCall != PictureCall::Framebuffer)
        return isDepth(texture.internalFormat)
                   ? refuse("programs copy colours", path, keyOf<&Texture::internalFormat>())
                   : Result<void>();
    if (isFloat(texture.internalFormat))
        return refuse(Sentence("programs draw into textures of limited colours; one of {0} can be copied",
                               rowOf(texture.internalFormat).name),
                      path, keyOf<&Texture::internalFormat>());
    if (!isRenderable(texture.internalFormat))
        return refuse(Sentence("nothing can be drawn into a texture of {0}; it can be copied",
                               rowOf(texture.internalFormat).name),
                      path, keyOf<&Texture::internalFormat>());
    if (readsItself(scene, texture))
        return refuse("what a pass reads of the texture that it draws into is undefined; it can be copied",
                      path, keyOf<&Texture::pictureCall>());
    return {};
}

} // namespace

std::vector<std::size_t> picturesOf(const Emission& emission) {
    std::vector<std::size_t> pictures;
    for (std::size_t i = 0; i < emission.objects.size(); ++i) {
        const Texture& texture = textureOf(emission, i);
        const std::vector<PictureKey> shown = shownPictures(emission.scene);
        if (texture.source == SourceKind::Picture && !emission.leftOut.contains(i) &&
            std::ranges::find(shown, pictureOf(texture)) != shown.end())
            pictures.push_back(i);
    }
    return pictures;
}

std::vector<std::size_t> passesOf(const Emission& emission, std::size_t object) {
    std::vector<std::size_t> passes;
    for (std::size_t p = 0; p < emission.scene.passes.size(); ++p) {
        const Pass& pass = emission.scene.passes[p];
        if (pass.picture == textureOf(emission, object).picture && drawsAnything(emission.scene, pass))
            passes.push_back(p);
    }
    return passes;
}

Result<void> checkPictures(const Scene& scene, const KeyFrames& keys) {
    const std::vector<PictureKey> shown = shownPictures(scene);
    for (const TextureObject& object : textureObjectsOf(scene, keys)) {
        const Texture& texture = scene.textures[object.texture];
        if (texture.source != SourceKind::Picture ||
            std::ranges::find(shown, pictureOf(texture)) == shown.end())
            continue;
        if (const Result<void> checked = checkPicture(scene, object); !checked)
            return checked;
    }
    return {};
}

void writePictureRoom(Emission& emission, std::size_t object) {
    CodeWriter& writer = emission.writer;
    const Part size = sizeOf(emission, object);
    const std::vector<std::size_t> shown = picturesOf(emission);
    if (std::ranges::find(shown, object) == shown.end())
        return writer.comment("nothing shows it");
    const bool isBlack = !unfinishedReads(emission.scene).empty();
    if (isBlack)
        emission.atStart.add({plain(fmt::format("static const GLubyte black{}[", object)),
                              size,
                              plain(" * "),
                              size,
                              plain(" * 4]; "),
                              {Part::Kind::Comment, "/* what it shows before it is drawn */"}});
    writer.add({call("glTexImage2D"), plain("(GL_TEXTURE_2D, 0, "), formatOf(emission, object), plain(", "),
                size, plain(", "), size,
                plain(fmt::format(", 0, GL_RGBA, {}, {});", unsignedByteType,
                                  isBlack ? fmt::format("black{}", object) : "NULL"))});
    if (textureOf(emission, object).pictureCall != PictureCall::Framebuffer)
        return;
    emission.atStart.add({plain(fmt::format("static GLuint picture{}; ", object)),
                          {Part::Kind::Comment, "/* a framebuffer object */"}});
    writer.add("GLuint depths;");
    writer.add("glGenRenderbuffers(1, &depths);");
    writer.add("glBindRenderbuffer(GL_RENDERBUFFER, depths);");
    writer.add({call("glRenderbufferStorage"), plain("(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, "), size,
                plain(", "), size, plain(");")});
    writer.add(fmt::format("glGenFramebuffers(1, &picture{});", object));
    writer.add(fmt::format("glBindFramebuffer(GL_FRAMEBUFFER, picture{});", object));
    writer.add(fmt::format("glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, "
                           "textures[{}], 0);",
                           object));
    writer.add("glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths);");
    writer.add("glBindFramebuffer(GL_FRAMEBUFFER, 0);");
}

int beginPicture(Emission& emission, std::size_t object) {
    CodeWriter& writer = emission.writer;
    const Texture& texture = textureOf(emission, object);
    writer.heading(
        fmt::format("picture {}, for texture {}", texture.picture, emission.objects[object].texture));
    writer.open(emission.moves ? fmt::format("static void drawPicture{}(double seconds)", object)
                               : fmt::format("static void drawPicture{}(void)", object));
    writer.add({plain("const int width = "), sizeOf(emission, object), plain(";")});
    writer.add("const int height = width;");
    if (texture.pictureCall == PictureCall::Framebuffer)
        writer.add(fmt::format("glBindFramebuffer(GL_FRAMEBUFFER, picture{});", object));
    return writer.secondsUses();
}

void endPicture(Emission& emission, std::size_t object, int secondsUses) {
    CodeWriter& writer = emission.writer;
    const Texture& texture = textureOf(emission, object);
    const bool isCopied = texture.pictureCall != PictureCall::Framebuffer;
    if (!isCopied)
        writer.add("glBindFramebuffer(GL_FRAMEBUFFER, 0);");
    if (isCopied || texture.mipmaps == MipPolicy::GenerateMipmap) {
        writer.add(fmt::format("glActiveTexture({});", textureUnitName(0)),
                   emission.isCore || emission.activeUnit != 0);
        emission.activeUnit = 0;
        writer.add(fmt::format("glBindTexture(GL_TEXTURE_2D, textures[{}]);", object));
    }
    const std::string path = pathOf(emission.objects[object], keyOf<&Texture::pictureCall>());
    const Part name = choice(rowOf(texture.pictureCall).name, path);
    if (texture.pictureCall == PictureCall::CopyTexImage)
        writer.add({name, plain("(GL_TEXTURE_2D, 0, "), formatOf(emission, object),
                    plain(", 0, 0, width, height, 0);")});
    if (texture.pictureCall == PictureCall::CopyTexSubImage)
        writer.add({name, plain("(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);")});
    if (texture.mipmaps == MipPolicy::GenerateMipmap)
        writer.add("glGenerateMipmap(GL_TEXTURE_2D);");
    if (emission.moves && writer.secondsUses() == secondsUses)
        writer.add({plain("(void)seconds; "), {Part::Kind::Comment, "/* it does not move */"}});
    writer.close();
}

void writePictureCalls(Emission& emission) {
    CodeWriter& writer = emission.writer;
    const std::vector<std::size_t> pictures = picturesOf(emission);
    const int frames = shownFrames(emission.scene);
    if (pictures.empty())
        return;
    if (!unfinishedReads(emission.scene).empty()) {
        writer.comment("what is shown before it is drawn");
        writer.add(fmt::format("glActiveTexture({});", textureUnitName(0)));
        for (const std::size_t object : pictures) {
            writer.add(fmt::format("glBindTexture(GL_TEXTURE_2D, textures[{}]);", object));
            writer.add({call("glTexSubImage2D"), plain("(GL_TEXTURE_2D, 0, 0, 0, "), sizeOf(emission, object),
                        plain(", "), sizeOf(emission, object),
                        plain(fmt::format(", GL_RGBA, {}, black{});", unsignedByteType, object))});
        }
    }
    if (frames > 1) {
        writer.comment(
            "each frame shows pictures of the one before; a program that runs draws one and keeps them");
        writer.add(fmt::format("for (int frame = {}; frame >= 0; --frame) {{", frames - 1));
        writer.indent();
        if (emission.moves)
            writer.add({plain("const double then = fmax(fmin("), writer.seconds(), plain(", 0.0), "),
                        writer.seconds(), plain(fmt::format(" - frame / {:.1f});", 1 / frameInterval))});
    }
    const std::string time = !emission.moves ? "" : frames > 1 ? "then" : "seconds";
    for (const std::size_t object : pictures)
        writer.add(fmt::format("drawPicture{}({});", object, time));
    if (frames > 1) {
        writer.outdent();
        writer.add("}");
    }
}

} // namespace texplorer::emit

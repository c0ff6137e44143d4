#include "texplorer/conform/skip.h"

#include "texplorer/conform/made_files.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/texture/level_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace texplorer::conform {

namespace {

bool isDefinedDecal(BaseFormat format) {
    return format == BaseFormat::Rgb || format == BaseFormat::Rgba;
}

bool anyUnit(const Scene& scene, const Pass& pass, auto condition) {
    return pass.enabled && std::ranges::any_of(pass.units, [&](const Unit& unit) {
               const auto texture =
                   static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
               return unit.enabled && texture < scene.textures.size() &&
                      condition(unit, scene.textures[texture]);
           });
}

bool anyUnit(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.passes,
                               [&](const Pass& pass) { return anyUnit(scene, pass, condition); });
}

/// The first level that OpenGL is given.
PlannedLevel firstLevel(const Unit& unit, const Texture& texture) {
    const LevelPlan plan = planLevels(texture, madeImages().picturesOf(texture), unit.target);
    return plan.levels.empty() ? PlannedLevel{.width = 1, .height = 1, .depth = 1} : plan.levels.front();
}

bool isTooLarge(const Unit& unit, const Texture& texture, const DriverFacts& driver) {
    const PlannedLevel level = firstLevel(unit, texture);
    return std::max({level.width, level.height, level.depth}) > driver.maxTexels(unit.target);
}

constexpr bool isCompressed(const Texture& texture) {
    return texture.compression == Compression::Cached || texture.compression == Compression::Driver;
}

/// The type that glTexImage is told in a custom upload.
std::optional<TransferType> typeTold(const Unit& unit, const Texture& texture) {
    if (!texture.upload.custom)
        return std::nullopt;
    const LevelPlan plan = planLevels(texture, madeImages().picturesOf(texture), unit.target);
    return plan.upload ? std::optional(texture.upload.type) : std::nullopt;
}

bool isLinearAnywhere(const Texture& texture) {
    return texture.magFilter == MagFilter::Linear || reference::isLinear(texture.minFilter);
}

/// Whether the diagnosis says so on this driver.
bool isFound(const Scene& scene, const Driver& driver, std::string_view rule) {
    DriverFacts facts = driver.facts;
    facts.renderer = driver.name;
    facts.version = driver.version;
    const std::vector<Finding> findings = diagnose(scene, madeImages(), facts);
    return std::ranges::find(findings, rule, &Finding::rule) != findings.end();
}

bool hasMesh(const Scene& scene) {
    return std::ranges::find(scene.models, Shape::Mesh, &Model::shape) != scene.models.end();
}

bool hasSphereMap(const Scene& scene) {
    return anyUnit(scene, [](const Unit& unit, const Texture&) {
        return (unit.texGenS.enabled && unit.texGenS.mode == TexGenMode::SphereMap) ||
               (unit.texGenT.enabled && unit.texGenT.mode == TexGenMode::SphereMap);
    });
}

bool hasLines(const Model& model) {
    const Primitive primitive = model.mesh.primitive;
    return model.shape == Shape::Mesh &&
           (primitive == Primitive::Lines || primitive == Primitive::LineStrip ||
            primitive == Primitive::LineLoop);
}

bool anyModel(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return std::ranges::any_of(drawnModels(scene, pass),
                                   [&](std::size_t model) { return condition(scene.models[model]); });
    });
}

constexpr std::array skipRows{
    Skip{
        "undefined-decal",
        [](const Scene& scene, const Pair&, const Driver&) {
            return anyUnit(scene, [](const Unit& unit, const Texture& texture) {
                return unit.envMode == EnvMode::Decal && !isCompressed(texture) &&
                       !isDefinedDecal(baseFormat(texture.internalFormat));
            });
        },
        N_("GL_DECAL is undefined for ALPHA, LUMINANCE, LUMINANCE_ALPHA and INTENSITY (OpenGL 2.1, table 3.21)")},
    Skip{"switch-over",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) &&
                    (driver.name.starts_with("llvmpipe") || driver.name.starts_with("softpipe")) &&
                    anyUnit(scene, [](const Unit&, const Texture& texture) {
                        return reference::switchOverOf(texture.magFilter, texture.minFilter) > 0;
                    });
         },
         N_("llvmpipe and softpipe use 0 for the constant c between magnification and minification; the "
            "specification uses 0.5 for these filters (OpenGL 2.1, section 3.8.9)")},
    Skip{"driver-compression",
         [](const Scene& scene, const Pair& pair, const Driver&) {
             return pair.has(RendererKind::Reference) &&
                    anyUnit(scene, [](const Unit&, const Texture& texture) {
                        return texture.compression == Compression::Driver;
                    });
         },
         N_("drivers may compress an image in any way (OpenGL 2.1, section 3.8.1)")},
    Skip{
        "signed-upload",
        [](const Scene& scene, const Pair& pair, const Driver&) {
            return pair.has(RendererKind::Reference) &&
                   anyUnit(scene, [](const Unit& unit, const Texture& texture) {
                       const std::optional<TransferType> type = typeTold(unit, texture);
                       return type && (type == TransferType::Byte || type == TransferType::Short ||
                                       type == TransferType::Int);
                   });
        },
        N_("OpenGL 4.2 converts signed numbers to colours by c / (2^(b - 1) - 1), and drivers such as Mesa do "
           "so in all versions; OpenGL 2.1 by (2c + 1) / (2^b - 1) (table 2.9)")},
    Skip{"float-upload",
         [](const Scene& scene, const Pair& pair, const Driver&) {
             return pair.has(RendererKind::Reference) &&
                    anyUnit(scene, [](const Unit& unit, const Texture& texture) {
                        const Upload& upload = texture.upload;
                        const bool holdsFloats = upload.memory == MemoryRows::Layout &&
                                                 upload.memoryType == TransferType::Float &&
                                                 !upload.swapBytes;
                        return typeTold(unit, texture) == TransferType::Float && !holdsFloats;
                    });
         },
         N_("other bytes read as floats may be infinite or no numbers, which OpenGL 2.1 leaves open (section "
            "2.1.1)")},
    Skip{"no-borders",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && !driver.facts.textureBorders &&
                    anyUnit(scene, [](const Unit&, const Texture& texture) { return texture.border > 0; });
         },
         N_("the driver drops the border of an image, as Mesa does; tests compare the reference with the "
            "specification's numbers")},
    Skip{"hint",
         [](const Scene& scene, const Pair& pair, const Driver&) {
             return pair.has(RendererKind::Fixed) && scene.view.perspectiveHint == HintMode::Fastest;
         },
         N_("the fixed function may ignore GL_PERSPECTIVE_CORRECTION_HINT; the shaders and the reference "
            "don't and can be compared")},
    Skip{"no-s3tc",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && !driver.facts.s3tc &&
                    anyUnit(scene, [](const Unit&, const Texture& texture) { return isCompressed(texture); });
         },
         N_("the driver lacks GL_EXT_texture_compression_s3tc")},
    Skip{"no-anisotropy",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) &&
                    anyUnit(scene, [&](const Unit&, const Texture& texture) {
                        return texture.maxAnisotropy > driver.facts.maxAnisotropy;
                    });
         },
         N_("the driver has less anisotropy than the texture asks for, or none")},
    Skip{
        "held-back",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) && driver.name.starts_with("llvmpipe") &&
                   anyUnit(scene,
                           [](const Unit&, const Texture& texture) { return texture.maxAnisotropy >= 2; }) &&
                   isFound(scene, driver, "held-back");
        },
        N_("llvmpipe is given less where it crashes (1D textures), compares no depths, reads levels that the "
           "filter lacks, or would visit texels for seconds to hours because coordinates change fast or q crosses 0")},
    Skip{"zero-normal",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Fixed) && hasMesh(scene) && isFound(scene, driver, "zero-normal");
         },
         N_("a normal without a length is undefined under GL_NORMALIZE (OpenGL 2.1, sections 2.11.3 and "
            "2.1.1); the shaders and the reference keep it 0 and can be compared")},
    Skip{"sphere-map-rim",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Fixed) && hasSphereMap(scene) &&
                    isFound(scene, driver, "sphere-map-rim");
         },
         N_("where the reflection points straight away from the eye, GL_SPHERE_MAP divides by 0 (OpenGL 2.1, "
            "section 2.11.4); the shaders and the reference use the middle of the image")},
    Skip{"long-line",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && driver.name.starts_with("llvmpipe") &&
                    hasMesh(scene) && isFound(scene, driver, "long-line");
         },
         N_("llvmpipe loses pixels at the ends of lines that are longer than a million pixels")},
    Skip{"anisotropy-method",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) &&
                    driver.anisotropy() == reference::AnisotropyMethod::Probes &&
                    anyUnit(scene,
                            [](const Unit&, const Texture& texture) { return texture.maxAnisotropy > 1; });
         },
         N_("EXT_texture_filter_anisotropic does not define the method, and this driver's is unknown")},
    Skip{"ellipse-of-one-level",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                    anyUnit(scene, [](const Unit&, const Texture& texture) {
                        return texture.maxAnisotropy > 1 && !reference::blendsLevels(texture.minFilter);
                    });
         },
         N_("softpipe filters anisotropically only with GL_*_MIPMAP_LINEAR")},
    Skip{
        "mirrored-ellipse",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) &&
                   driver.anisotropy() == reference::AnisotropyMethod::Ellipse &&
                   anyUnit(scene, [](const Unit&, const Texture& texture) {
                       return texture.maxAnisotropy > 1 && (texture.wrapS == Wrap::MirroredRepeat ||
                                                            texture.wrapT == Wrap::MirroredRepeat);
                   });
        },
        N_("llvmpipe and softpipe read the texels of the ellipse at their lower edge instead of their middle, "
           "so a mirrored image is off by one texel")},
    Skip{
        "filtered-depths",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                   anyUnit(scene, [](const Unit&, const Texture& texture) {
                       return isDepth(texture.internalFormat) &&
                              texture.compareMode == CompareMode::RToTexture && isLinearAnywhere(texture);
                   });
        },
        N_("with GL_LINEAR softpipe compares r with the mean of the depths instead of each depth; OpenGL 2.1, "
           "section 3.8.14, allows both")},
    Skip{
        "mirrored-slices",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                   anyUnit(scene, [](const Unit& unit, const Texture& texture) {
                       return unit.target == Target::Texture3D && texture.wrapR == Wrap::MirroredRepeat &&
                              isLinearAnywhere(texture);
                   });
        },
        N_("softpipe reads the neighbouring slice where GL_MIRRORED_REPEAT with a linear filter hits exactly "
           "the middle of a slice")},
    Skip{"half-way",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             const auto isHalf = [](float lambda) { return lambda - std::floor(lambda) == 0.5F; };
             return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                    anyUnit(scene, [&](const Unit&, const Texture& texture) {
                        return reference::wantsMipmaps(texture.minFilter) &&
                               !reference::blendsLevels(texture.minFilter) &&
                               (isHalf(texture.minLod) || isHalf(texture.maxLod));
                    });
         },
         N_("softpipe uses the smaller of two levels where lambda is clamped to half-way between them; the "
            "specification uses the larger one (OpenGL 2.1, equation 3.25)")},
    Skip{
        "cube-wrap",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) && driver.name.starts_with("llvmpipe") &&
                   std::ranges::any_of(scene.passes, [&](const Pass& pass) {
                       return !pass.seamlessCubeMap &&
                              anyUnit(scene, pass, [](const Unit& unit, const Texture& texture) {
                                  return unit.target == Target::CubeMap && isLinearAnywhere(texture) &&
                                         (texture.wrapS != Wrap::ClampToEdge ||
                                          texture.wrapT != Wrap::ClampToEdge);
                              });
                   });
        },
        N_("llvmpipe clamps a cube map's linear filter to the edge of its face, whatever the wrap modes are; "
           "the specification wraps on the face as on any image (OpenGL 2.1, section 3.8.6)")},
    Skip{
        "mixed-clamp",
        [](const Scene& scene, const Pair& pair, const Driver& driver) {
            return pair.has(RendererKind::Reference) && driver.name.starts_with("llvmpipe") &&
                   anyUnit(scene, [](const Unit&, const Texture& texture) {
                       const bool magnifies = texture.magFilter == MagFilter::Linear;
                       return magnifies != reference::isLinear(texture.minFilter) &&
                              (texture.wrapS == Wrap::Clamp || texture.wrapT == Wrap::Clamp ||
                               texture.wrapR == Wrap::Clamp);
                   });
        },
        N_("where only some of eight pixels are magnified, llvmpipe reads GL_NEAREST half a texel lower: with "
           "GL_CLAMP the border shows")},
    Skip{"no-seamless-cube-maps",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && !driver.facts.seamlessCubeMaps &&
                    std::ranges::any_of(scene.passes, [&](const Pass& pass) {
                        return pass.seamlessCubeMap &&
                               anyUnit(scene, pass, [](const Unit& unit, const Texture&) {
                                   return unit.target == Target::CubeMap;
                               });
                    });
         },
         N_("the driver has neither OpenGL 3.2 nor GL_ARB_seamless_cube_map")},
    Skip{"seamless-corners",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                    std::ranges::any_of(scene.passes, [&](const Pass& pass) {
                        return pass.seamlessCubeMap &&
                               anyUnit(scene, pass, [](const Unit& unit, const Texture& texture) {
                                   return unit.target == Target::CubeMap && isLinearAnywhere(texture);
                               });
                    });
         },
         N_("where three faces meet, softpipe uses a neighbour's texel for the missing fourth; "
            "GL_ARB_seamless_cube_map recommends the mean of the three but does not require it")},
    Skip{"too-large",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) &&
                    anyUnit(scene, [&](const Unit& unit, const Texture& texture) {
                        return isTooLarge(unit, texture, driver.facts);
                    });
         },
         N_("the driver's maximum texture size is too small")},
    Skip{"no-npot",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && !driver.facts.nonPowerOfTwo &&
                    anyUnit(scene, [](const Unit& unit, const Texture& texture) {
                        const PlannedLevel level = firstLevel(unit, texture);
                        return !arePowersOfTwo(level.width, level.height, level.depth);
                    });
         },
         N_("the driver supports powers of two only (no GL_ARB_texture_non_power_of_two)")},
    Skip{"even-lines",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && driver.name.starts_with("llvmpipe") &&
                    anyModel(scene, [](const Model& model) {
                        return hasLines(model) && reference::roundedSize(model.lineWidth) % 2 == 0;
                    });
         },
         N_("llvmpipe tests the diamonds at the ends of the original line; the specification moves lines of "
            "even width by half a pixel first (OpenGL 2.1, section 3.4.2)")},
    Skip{"whole-pixels",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Reference) && driver.name.starts_with("softpipe") &&
                    anyModel(scene, [](const Model& model) {
                        const bool points =
                            model.shape == Shape::Mesh && model.mesh.primitive == Primitive::Points;
                        return hasLines(model) || (points && reference::roundedSize(model.pointSize) > 1);
                    });
         },
         N_("softpipe draws lines between whole pixels, and wide lines and points as squares a quarter of a "
            "pixel off the centre; OpenGL 2.1 allows one pixel more or less for lines (section 3.4.1)")},
    Skip{"unrounded-alpha",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Fixed) && driver.name.starts_with("softpipe") &&
                    std::ranges::any_of(scene.passes, [](const Pass& pass) {
                        const float bytes = pass.alphaRef * 255;
                        return pass.enabled && pass.alphaTest && bytes != std::floor(bytes);
                    });
         },
         N_("softpipe's fixed function compares alpha with a reference value that is not rounded to the bits "
            "of the framebuffer (OpenGL 2.1, section 4.1.4)")},
    Skip{"sum-in-fog",
         [](const Scene& scene, const Pair& pair, const Driver& driver) {
             return pair.has(RendererKind::Fixed) && driver.version.find("Mesa") != std::string::npos &&
                    scene.light.colorControl == ColorControl::SeparateSpecular &&
                    std::ranges::any_of(scene.passes, [](const Pass& pass) {
                        return pass.enabled && pass.lighting && pass.fog.enabled;
                    });
         },
         N_("Mesa's fixed function clamps the colour sum after the fog; the specification clamps it before "
            "(OpenGL 2.1, section 3.9)")},
    Skip{"fog-without-length",
         [](const Scene& scene, const Pair& pair, const Driver&) {
             return pair.has(RendererKind::Fixed) && std::ranges::any_of(scene.passes, [](const Pass& pass) {
                        return pass.enabled && pass.fog.enabled && pass.fog.mode == FogMode::Linear &&
                               pass.fog.start == pass.fog.end;
                    });
         },
         N_("linear fog that ends where it starts divides by 0 (OpenGL 2.1, section 3.10)")},
    Skip{"too-few-units",
         [](const Scene& scene, const Pair&, const Driver& driver) {
             return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
                 for (std::size_t u = 0; u < pass.units.size(); ++u) {
                     if (pass.enabled && pass.units[u].enabled &&
                         static_cast<int>(u) >= driver.facts.textureUnits)
                         return true;
                 }
                 return false;
             });
         },
         N_("the driver has fewer texture units than the scene uses")},
};

} // namespace

std::span<const Skip> skips() {
    return skipRows;
}

const Skip* skipOf(const Scene& scene, const Pair& pair, const Driver& driver) {
    const auto found =
        std::ranges::find_if(skipRows, [&](const Skip& row) { return row.applies(scene, pair, driver); });
    return found == skipRows.end() ? nullptr : &*found;
}

} // namespace texplorer::conform

// The fragment stage: OpenGL 2.1, sections 3.8 to 4.1.

//@ version
#version 330 core
//@ version of OpenGL ES
#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
//@ inputs GL_SMOOTH
// Interpolated between the vertices.
in vec4 primaryColor;
//@ inputs GL_FLAT
// Interpolated between the vertices; a flat colour is that of a triangle's last vertex.
flat in vec4 primaryColor;
//@ inputs GL_SMOOTH GL_FASTEST
// Interpolated between the vertices, times w: over w they are linear in the window, without perspective.
in vec4 primaryColorTimesW;
//@ back input GL_SMOOTH
in vec4 backPrimaryColor;
//@ back input GL_FLAT
flat in vec4 backPrimaryColor;
//@ back input GL_SMOOTH GL_FASTEST
in vec4 backPrimaryColorTimesW;
//@ w input
in float w;
//@ secondary input GL_SMOOTH
in vec3 secondaryColor;
//@ secondary input GL_SMOOTH GL_FASTEST
in vec3 secondaryColorTimesW;
//@ secondary input GL_FLAT
flat in vec3 secondaryColor;
//@ back secondary input GL_SMOOTH
in vec3 backSecondaryColor;
//@ back secondary input GL_FLAT
flat in vec3 backSecondaryColor;
//@ back secondary input GL_SMOOTH GL_FASTEST
in vec3 backSecondaryColorTimesW;
//@ coordinate input
in vec4 texCoordUNIT;
//@ sampler GL_TEXTURE_1D
uniform sampler1D textureUNIT;
//@ sampler GL_TEXTURE_2D
uniform sampler2D textureUNIT;
//@ sampler GL_TEXTURE_1D GL_COMPARE_R_TO_TEXTURE
uniform sampler1DShadow textureUNIT;
//@ sampler GL_TEXTURE_2D GL_COMPARE_R_TO_TEXTURE
uniform sampler2DShadow textureUNIT;
//@ sampler GL_TEXTURE_3D
uniform sampler3D textureUNIT;
//@ sampler GL_TEXTURE_CUBE_MAP
uniform samplerCube textureUNIT;
//@ bias
uniform float lodBiasUNIT; // GL_TEXTURE_LOD_BIAS of the unit
//@ environment color
uniform vec4 environmentColorUNIT; // GL_TEXTURE_ENV_COLOR
//@ alpha reference
uniform float alphaReference; // in 255ths
//@ outputs
layout(location = 0) out vec4 fragmentColor;
//@ begin

void main() {
//@ lookup
    vec4 texelUNIT = textureProj(textureUNIT, texCoordUNIT); // divides by q
//@ lookup with bias
    vec4 texelUNIT = textureProj(textureUNIT, texCoordUNIT, lodBiasUNIT); // divides by q
//@ lookup of a depth
    float depthUNIT = textureProj(textureUNIT, texCoordUNIT).r; // divides by q
//@ lookup of a depth with bias
    float depthUNIT = textureProj(textureUNIT, texCoordUNIT, lodBiasUNIT).r; // divides by q
//@ lookup that compares
    float depthUNIT = textureProj(textureUNIT, texCoordUNIT); // r / q with each depth: 1 where it passes
//@ lookup that compares with bias
    float depthUNIT = textureProj(textureUNIT, texCoordUNIT, lodBiasUNIT); // r / q with each depth
//@ depth as GL_LUMINANCE
    vec4 texelUNIT = vec4(vec3(depthUNIT), 1.0); // GL_DEPTH_TEXTURE_MODE
//@ depth as GL_INTENSITY
    vec4 texelUNIT = vec4(depthUNIT); // GL_DEPTH_TEXTURE_MODE
//@ depth as GL_ALPHA
    vec4 texelUNIT = vec4(0.0, 0.0, 0.0, depthUNIT); // GL_DEPTH_TEXTURE_MODE
//@ lookup of a direction
    vec4 texelUNIT = texture(textureUNIT, texCoordUNIT.stp / texCoordUNIT.q); // of the face that it hits
//@ lookup of a direction with bias
    vec4 texelUNIT = texture(textureUNIT, texCoordUNIT.stp / texCoordUNIT.q, lodBiasUNIT);
//@ place that ends
    // GL_CLAMP, which OpenGL's core profile has not: GL_CLAMP_TO_BORDER for coordinates that end at the edge.
    vec3 placeUNIT = texCoordUNIT.stp / texCoordUNIT.q;
    vec3 endUNIT = placeUNIT;
//@ end of a coordinate
    endUNIT.MEMBER = clamp(endUNIT.MEMBER, 0.0, 0.99999994); // below 1, for GL_NEAREST knows no border
//@ lookup GL_TEXTURE_1D that ends
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT.s, dFdx(placeUNIT.s), dFdy(placeUNIT.s));
//@ lookup GL_TEXTURE_2D that ends
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT.st, dFdx(placeUNIT.st), dFdy(placeUNIT.st));
//@ lookup GL_TEXTURE_3D that ends
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT, dFdx(placeUNIT), dFdy(placeUNIT));
//@ lookup GL_TEXTURE_1D that ends with bias
    float scaleUNIT = exp2(lodBiasUNIT);
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT.s, dFdx(placeUNIT.s) * scaleUNIT, dFdy(placeUNIT.s) * scaleUNIT);
//@ lookup GL_TEXTURE_2D that ends with bias
    float scaleUNIT = exp2(lodBiasUNIT);
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT.st, dFdx(placeUNIT.st) * scaleUNIT, dFdy(placeUNIT.st) * scaleUNIT);
//@ lookup GL_TEXTURE_3D that ends with bias
    float scaleUNIT = exp2(lodBiasUNIT);
    vec4 texelUNIT = textureGrad(textureUNIT, endUNIT, dFdx(placeUNIT) * scaleUNIT, dFdy(placeUNIT) * scaleUNIT);
//@ primary color
    vec4 color = primaryColor;
//@ primary color without perspective
    vec4 primaryColor = primaryColorTimesW / w;
//@ secondary color without perspective
    vec3 secondaryColor = secondaryColorTimesW / w;
//@ primary color of the side
    vec4 primaryColor = gl_FrontFacing ? primaryColor : backPrimaryColor; // GL_LIGHT_MODEL_TWO_SIDE
//@ secondary color of the side
    vec3 secondaryColor = gl_FrontFacing ? secondaryColor : backSecondaryColor;
//@ primary color of the side without perspective
    vec4 primaryColor = (gl_FrontFacing ? primaryColorTimesW : backPrimaryColorTimesW) / w;
//@ secondary color of the side without perspective
    vec3 secondaryColor = (gl_FrontFacing ? secondaryColorTimesW : backSecondaryColorTimesW) / w;
//@ color sum

    // Section 3.9: the highlight is added after texturing.
    color.rgb = min(color.rgb + secondaryColor, 1.0);
//@ alpha test

    // Section 4.1.4. Both numbers have as many bits as the framebuffer's alpha.
    float alpha = floor(color.a * 255.0 + 0.5);
//@ alpha GL_NEVER
    discard;
//@ alpha GL_LESS
    if (!(alpha < alphaReference)) discard;
//@ alpha GL_EQUAL
    if (!(alpha == alphaReference)) discard;
//@ alpha GL_LEQUAL
    if (!(alpha <= alphaReference)) discard;
//@ alpha GL_GREATER
    if (!(alpha > alphaReference)) discard;
//@ alpha GL_NOTEQUAL
    if (!(alpha != alphaReference)) discard;
//@ alpha GL_GEQUAL
    if (!(alpha >= alphaReference)) discard;
//@ end

    fragmentColor = color;
}

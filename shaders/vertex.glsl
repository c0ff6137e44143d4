// The vertex stage: OpenGL 2.1, sections 2.11 to 2.14.
//
// These files are cut into pieces; a line that begins with //@ names the one below it. A pass is put together
// from the pieces that its state needs. UNIT stands for the number of a texture unit.

//@ version
#version 330 core
//@ version of OpenGL ES
#version 300 es
//@ attributes
// What each vertex was given.
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec4 color; // glColor, or the vertex's own
//@ coordinate attribute
layout(location = LOCATION) in vec4 givenCoordUNIT; // s, t, r and q
//@ matrices
// Section 2.11.2: from the model to what the eye sees.
uniform mat4 modelViewProjection;
//@ model-view matrix
uniform mat4 modelView;
//@ normal matrix
uniform mat3 normalMatrix; // the inverse of modelView's rotation and scale, transposed
//@ point size uniform
uniform float pointSize; // glPointSize
//@ texture matrix
uniform mat4 textureMatrixUNIT;
//@ outputs GL_SMOOTH
// What the rasteriser interpolates for the fragments.
invariant gl_Position; // a second pass hits exactly the depth of the first
out vec4 primaryColor;
//@ outputs GL_FLAT
// What the rasteriser interpolates for the fragments; a flat colour is that of a triangle's last vertex.
invariant gl_Position; // a second pass hits exactly the depth of the first
flat out vec4 primaryColor;
//@ outputs GL_SMOOTH GL_FASTEST
// What the rasteriser interpolates for the fragments. It divides by w: what was multiplied by w before is linear
// in the window, as if there were no perspective.
invariant gl_Position; // a second pass hits exactly the depth of the first
vec4 primaryColor;
out vec4 primaryColorTimesW;
//@ back output GL_SMOOTH
out vec4 backPrimaryColor;
//@ back output GL_FLAT
flat out vec4 backPrimaryColor;
//@ back output GL_SMOOTH GL_FASTEST
vec4 backPrimaryColor;
out vec4 backPrimaryColorTimesW;
//@ w output
out float w;
//@ secondary output GL_SMOOTH
out vec3 secondaryColor;
//@ secondary output GL_SMOOTH GL_FASTEST
vec3 secondaryColor;
out vec3 secondaryColorTimesW;
//@ secondary output GL_FLAT
flat out vec3 secondaryColor;
//@ back secondary output GL_SMOOTH
out vec3 backSecondaryColor;
//@ back secondary output GL_SMOOTH GL_FASTEST
vec3 backSecondaryColor;
out vec3 backSecondaryColorTimesW;
//@ back secondary output GL_FLAT
flat out vec3 backSecondaryColor;
//@ coordinate output
out vec4 texCoordUNIT;
//@ direction

// What points where v does and has the length 1. A v of length 0 stays: of it normalize would make no number.
vec3 direction(vec3 v) {
    float size = length(v);
    return size > 0.0 ? v / size : v;
}
//@ begin

void main() {
    gl_Position = modelViewProjection * vec4(position, 1.0);
//@ eye position
    vec3 eyePosition = vec3(modelView * vec4(position, 1.0));
//@ eye normal
    vec3 eyeNormal = direction(normalMatrix * normal); // GL_NORMALIZE
//@ unlit
    primaryColor = clamp(color, 0.0, 1.0);
//@ coordinate

    // Unit UNIT
    vec4 coordUNIT = givenCoordUNIT;
//@ coordinate with matrix
    texCoordUNIT = textureMatrixUNIT * coordUNIT;
//@ coordinate as it is
    texCoordUNIT = coordUNIT;
//@ coordinate without perspective
    texCoordUNIT *= gl_Position.w; // and q with it: linear in the window, without perspective
//@ w

    w = gl_Position.w;
//@ colors without perspective
    primaryColorTimesW = primaryColor * w;
//@ secondary color without perspective
    secondaryColorTimesW = secondaryColor * w;
//@ back color without perspective
    backPrimaryColorTimesW = backPrimaryColor * w;
//@ back secondary color without perspective
    backSecondaryColorTimesW = backSecondaryColor * w;
//@ point size

    gl_PointSize = pointSize;
//@ end
}

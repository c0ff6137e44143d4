// Textures without samplers: what a sampler does, written out for OpenGL ES, which has neither 1D textures nor border
// colours, GL_CLAMP, luminance and biases. OpenGL 2.1, sections 3.8.6 to 3.8.9.
//
// All texels of a texture are in one list: level after level, of a cube map face after face, then slice after slice
// and row after row. A level is counted from GL_TEXTURE_BASE_LEVEL.

//@ uniforms
uniform sampler2D texelsUNIT; // the list, ROW texels in a row
uniform ivec4 levelsUNIT[LEVELS]; // of a level: width, height, depth, and its first texel in the list
//@ border color
uniform vec4 borderColorUNIT; // GL_TEXTURE_BORDER_COLOR
//@ lod uniforms
uniform vec3 lodUNIT; // the sum of the biases, GL_TEXTURE_MIN_LOD and GL_TEXTURE_MAX_LOD
//@ last level
uniform float lastLevelUNIT; // the smallest one that is used
//@ anisotropy
uniform float anisotropyUNIT; // GL_TEXTURE_MAX_ANISOTROPY_EXT
//@ compared depth
float comparedUNIT; // r of this fragment
//@ finite

// Coordinates that are no numbers become 0.
vec3 finite(vec3 coords) {
    return mix(vec3(0.0), coords, lessThan(abs(coords), vec3(3.4e38)));
}
//@ finiteDirection

// A direction that is none, because a coordinate is no number, becomes 0.
vec3 finiteDirection(vec3 coords) {
    return all(lessThan(abs(coords), vec3(3.4e38))) ? coords : vec3(0.0);
}
//@ repeated

// GL_REPEAT: where a coordinate lies among n texels.
float repeated(float s, float n) {
    return (s - floor(s)) * n;
}
//@ mirrored

// GL_MIRRORED_REPEAT: where a coordinate lies among n texels.
float mirrored(float s, float n) {
    float whole = floor(s);
    float part = s - whole;
    return clamp((mod(whole, 2.0) == 0.0 ? part : 1.0 - part) * n, 0.5, n - 0.5);
}
//@ clampedToEdge

// GL_CLAMP_TO_EDGE: where a coordinate lies among n texels.
float clampedToEdge(float s, float n) {
    return clamp(s * n, 0.5, n - 0.5);
}
//@ clampedToBorder

// GL_CLAMP_TO_BORDER: where a coordinate lies among n texels.
float clampedToBorder(float s, float n) {
    return clamp(s * n, -0.5, n + 0.5);
}
//@ clamped

// GL_CLAMP: where a coordinate lies among n texels.
float clamped(float s, float n) {
    return clamp(s * n, 0.0, n);
}
//@ size

vec3 sizeUNIT(int level) {
    return vec3(levelsUNIT[level].xyz);
}
//@ size without border

// A border of one texel lies around each level.
vec3 sizeUNIT(int level) {
    return vec3(levelsUNIT[level].xyz - 2 * RIM);
}
//@ begin texel

vec4 texelUNITAt(int level, ivec3 at) {
    ivec4 stored = levelsUNIT[level];
//@ border image
    at += RIM;
//@ texel
    int place = stored.w + (at.z * stored.y + at.y) * stored.x + at.x;
    vec4 texel = texelFetch(texelsUNIT, ivec2(place % ROW, place / ROW), 0);
//@ texel or border
    bool beyond = any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, stored.xyz));
    int place = beyond ? 0 : stored.w + (at.z * stored.y + at.y) * stored.x + at.x;
    vec4 texel = beyond ? borderColorUNIT : texelFetch(texelsUNIT, ivec2(place % ROW, place / ROW), 0);
//@ compare GL_NEVER
    texel = vec4(0.0);
//@ compare GL_LESS
    texel = vec4(comparedUNIT < texel.r ? 1.0 : 0.0);
//@ compare GL_EQUAL
    texel = vec4(comparedUNIT == texel.r ? 1.0 : 0.0);
//@ compare GL_LEQUAL
    texel = vec4(comparedUNIT <= texel.r ? 1.0 : 0.0);
//@ compare GL_GREATER
    texel = vec4(comparedUNIT > texel.r ? 1.0 : 0.0);
//@ compare GL_NOTEQUAL
    texel = vec4(comparedUNIT != texel.r ? 1.0 : 0.0);
//@ compare GL_GEQUAL
    texel = vec4(comparedUNIT >= texel.r ? 1.0 : 0.0);
//@ compare GL_ALWAYS
    texel = vec4(1.0);
//@ end texel
    return texel;
}
//@ faces

// Table 3.19: the directions in which s and t grow on the faces +x, -x, +y, -y, +z and -z, and where these lie.
const ivec3 faceS[6] = ivec3[6](ivec3(0, 0, -1), ivec3(0, 0, 1), ivec3(1, 0, 0), ivec3(1, 0, 0), ivec3(1, 0, 0), ivec3(-1, 0, 0));
const ivec3 faceT[6] = ivec3[6](ivec3(0, -1, 0), ivec3(0, -1, 0), ivec3(0, 0, 1), ivec3(0, 0, -1), ivec3(0, -1, 0), ivec3(0, -1, 0));
const ivec3 faceAt[6] = ivec3[6](ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 1, 0), ivec3(0, -1, 0), ivec3(0, 0, 1), ivec3(0, 0, -1));

// The face that a direction hits.
int faceOf(vec3 v) {
    vec3 size = abs(v);
    return size.x >= size.y && size.x >= size.z ? (v.x < 0.0 ? 1 : 0) :
           size.y >= size.z ? (v.y < 0.0 ? 3 : 2) : (v.z < 0.0 ? 5 : 4);
}

// A direction along the axes of a face.
vec3 onFace(int face, vec3 v) {
    return vec3(dot(vec3(faceS[face]), v), dot(vec3(faceT[face]), v), dot(vec3(faceAt[face]), v));
}

// s and t on the face that a direction hits, and the number of the face.
vec3 faceCoords(vec3 v) {
    int face = faceOf(v);
    vec3 along = onFace(face, v);
    return vec3(along.z > 0.0 ? along.xy / along.z * 0.5 + 0.5 : vec2(0.5), face);
}

// How s and t on that face change if the direction changes.
vec2 faceChange(vec3 v, vec3 change) {
    int face = faceOf(v);
    vec3 along = onFace(face, v);
    vec3 by = onFace(face, change);
    return along.z > 0.0 ? (by.xy - along.xy / along.z * by.z) / along.z * 0.5 : vec2(0.0);
}
//@ folded

// A texel beyond one edge of a face lies on the next face.
ivec3 folded(ivec3 at, int n) {
    ivec2 middle = 2 * at.xy + 1 - n; // in halves of a texel from the middle of the face
    ivec3 place = faceS[at.z] * middle.x + faceT[at.z] * middle.y + faceAt[at.z] * n;
    ivec3 onto = abs(middle.x) > n ? faceS[at.z] * sign(middle.x) : faceT[at.z] * sign(middle.y);
    int excess = max(abs(middle.x), abs(middle.y)) - n;
    place -= (onto + faceAt[at.z]) * excess;
    int face = 2 * abs(onto.y) + 4 * abs(onto.z) + (onto.x + onto.y + onto.z < 0 ? 1 : 0);
    ivec3 s = faceS[face] * place;
    ivec3 t = faceT[face] * place;
    return ivec3((s.x + s.y + s.z + n - 1) / 2, (t.x + t.y + t.z + n - 1) / 2, face);
}
//@ around

// GL_TEXTURE_CUBE_MAP_SEAMLESS: beyond an edge lie the texels of the next face; where three faces meet, the mean of
// their texels.
vec4 texelUNITAround(int level, ivec3 at) {
    int n = int(sizeUNIT(level).x);
    ivec2 inside = clamp(at.xy, 0, n - 1);
    bvec2 beyond = notEqual(inside, at.xy);
    if (all(beyond))
        return (texelUNITAt(level, ivec3(inside, at.z)) +
                texelUNITAt(level, folded(ivec3(at.x, inside.y, at.z), n)) +
                texelUNITAt(level, folded(ivec3(inside.x, at.y, at.z), n))) / 3.0;
    return texelUNITAt(level, any(beyond) ? folded(at, n) : at);
}
//@ begin nearest

// GL_NEAREST: the texel that a place lies in.
vec4 nearestUNIT(int level, vec3 coords) {
    vec3 n = sizeUNIT(level);
//@ place of GL_TEXTURE_1D
    vec3 u = vec3(WRAP_S(coords.s, n.x), 0.0, 0.0);
//@ place of GL_TEXTURE_2D
    vec3 u = vec3(WRAP_S(coords.s, n.x), WRAP_T(coords.t, n.y), 0.0);
//@ place of GL_TEXTURE_3D
    vec3 u = vec3(WRAP_S(coords.s, n.x), WRAP_T(coords.t, n.y), WRAP_R(coords.p, n.z));
//@ place of GL_TEXTURE_CUBE_MAP
    vec3 u = vec3(WRAP_S(coords.s, n.x), WRAP_T(coords.t, n.y), coords.p); // r is the face
//@ end nearest
    return texelUNITAt(level, ivec3(mix(floor(u), n - 1.0, equal(u, n)))); // the end belongs to the last one
}
//@ begin linear

// GL_LINEAR: equations 3.22 to 3.24, the texels around a place by its distance from their centres.
vec4 linearUNIT(int level, vec3 coords) {
    vec3 n = sizeUNIT(level);
//@ corners
    vec3 corner = floor(u - 0.5);
    vec3 share = u - 0.5 - corner;
    ivec3 i = ivec3(corner);
    ivec3 j = i + 1;
//@ next to it GL_REPEAT
    i.AXIS = i.AXIS < 0 ? int(n.AXIS) - 1 : i.AXIS; // the ends are neighbours
    j.AXIS = j.AXIS == int(n.AXIS) ? 0 : j.AXIS;
//@ next to it GL_CLAMP_TO_EDGE | next to it GL_MIRRORED_REPEAT
    j.AXIS = min(j.AXIS, int(n.AXIS) - 1); // its share is 0
//@ end linear GL_TEXTURE_1D
    return mix(READ(level, ivec3(i.x, 0, 0)), READ(level, ivec3(j.x, 0, 0)), share.x);
}
//@ face of the corners
    i.z = int(coords.p); // the face
//@ end linear GL_TEXTURE_2D | end linear GL_TEXTURE_CUBE_MAP
    return mix(mix(READ(level, i), READ(level, ivec3(j.x, i.y, i.z)), share.x),
               mix(READ(level, ivec3(i.x, j.y, i.z)), READ(level, ivec3(j.x, j.y, i.z)), share.x), share.y);
}
//@ end linear GL_TEXTURE_3D
    return mix(mix(mix(READ(level, i), READ(level, ivec3(j.x, i.y, i.z)), share.x),
                   mix(READ(level, ivec3(i.x, j.y, i.z)), READ(level, ivec3(j.x, j.y, i.z)), share.x), share.y),
               mix(mix(READ(level, ivec3(i.x, i.y, j.z)), READ(level, ivec3(j.x, i.y, j.z)), share.x),
                   mix(READ(level, ivec3(i.x, j.y, j.z)), READ(level, j), share.x), share.y), share.z);
}
//@ only corner
    i.z = 0;
//@ level of detail

// Equations 3.18 to 3.20: how many levels smaller the texture is on the screen, rho texels for one pixel.
float levelOfDetail(float rho, vec3 lod) {
    float base = rho < 3.4e38 ? log2(max(rho, 1e-37)) : 0.0;
    return min(max(base + lod.x, lod.y), lod.z);
}
//@ begin filtered

vec4 filteredUNIT(float lambda, vec3 coords) {
//@ on the face
    coords = faceCoords(coords);
//@ one filter
    return FILTERED(0, coords);
}
//@ magnified
    if (!(lambda > SWITCH))
        return FILTERED(0, coords); // magnified: section 3.8.9
//@ the nearest level
    float level = lambda > 0.5 ? min(-floor(0.5 - lambda), lastLevelUNIT) : 0.0; // equation 3.25
    return FILTERED(int(level), coords);
}
//@ two levels
    float level = min(floor(lambda), lastLevelUNIT); // equations 3.26 to 3.28
    if (level == lastLevelUNIT)
        return FILTERED(int(level), coords);
    return mix(FILTERED(int(level), coords), FILTERED(int(level) + 1, coords), lambda - level);
}
//@ begin sample

vec4 sampleUNIT(vec3 given) {
    vec3 coords = FINITE(given);
//@ compares r
    comparedUNIT = given.p > 0.0 ? min(given.p, 1.0) : 0.0;
//@ changes
    vec3 alongX = dFdx(given);
    vec3 alongY = dFdy(given);
//@ footprint GL_TEXTURE_1D
    float x = abs(alongX.s * sizeUNIT(0).x);
    float y = abs(alongY.s * sizeUNIT(0).x);
//@ footprint GL_TEXTURE_2D
    float x = length(alongX.st * sizeUNIT(0).xy); // texels of the base level for a step to the next pixel
    float y = length(alongY.st * sizeUNIT(0).xy);
//@ footprint GL_TEXTURE_3D
    float x = length(alongX * sizeUNIT(0)); // texels of the base level for a step to the next pixel
    float y = length(alongY * sizeUNIT(0));
//@ footprint GL_TEXTURE_CUBE_MAP
    float x = length(faceChange(coords, alongX) * sizeUNIT(0).xy); // texels of the base level for a step to the next pixel
    float y = length(faceChange(coords, alongY) * sizeUNIT(0).xy);
//@ one sample
    return filteredUNIT(levelOfDetail(max(x, y), lodUNIT), coords);
}
//@ one sample without level of detail
    return filteredUNIT(0.0, coords);
}
//@ several samples

    // EXT_texture_filter_anisotropic: samples along the longer side of what the pixel covers.
    float longer = max(x, y);
    float count = longer > 0.0 && longer < 3.4e38 ? max(1.0, min(ceil(longer / min(x, y)), anisotropyUNIT)) : 1.0;
    float lambda = levelOfDetail(longer / count, lodUNIT);
    if (count == 1.0)
        return filteredUNIT(lambda, coords);
    vec3 along = x > y ? alongX : alongY;
    vec4 sum = vec4(0.0);
    for (float i = 1.0; i <= count; ++i)
        sum += filteredUNIT(lambda, coords + along * (i / (count + 1.0) - 0.5));
    return sum / count;
}
//@ lookup
    vec4 texelUNIT = sampleUNIT(texCoordUNIT.stp / texCoordUNIT.q);
//@ lookup of a depth
    float depthUNIT = sampleUNIT(texCoordUNIT.stp / texCoordUNIT.q).r;

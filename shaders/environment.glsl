// What a unit makes of the incoming colour and its texel: OpenGL 2.1, section 3.8.13, tables 3.21 and 3.22. A
// piece is a cell of the tables: an environment mode with the base internal formats that share it. A format
// without colour leaves the incoming colour alone, one without alpha the incoming alpha.

//@ unclamped

    // What a unit gives lies between 0 and 1; the texels of this format need not.
    color = clamp(color, 0.0, 1.0);
//@ GL_REPLACE GL_ALPHA

    // Unit UNIT, GL_REPLACE with alpha alone
    color.a = texelUNIT.a;
//@ GL_REPLACE GL_LUMINANCE | GL_REPLACE GL_RGB

    // Unit UNIT, GL_REPLACE without alpha
    color.rgb = texelUNIT.rgb;
//@ GL_REPLACE GL_LUMINANCE_ALPHA | GL_REPLACE GL_INTENSITY | GL_REPLACE GL_RGBA

    // Unit UNIT, GL_REPLACE
    color = texelUNIT;
//@ GL_MODULATE GL_ALPHA

    // Unit UNIT, GL_MODULATE with alpha alone
    color.a = color.a * texelUNIT.a;
//@ GL_MODULATE GL_LUMINANCE | GL_MODULATE GL_RGB

    // Unit UNIT, GL_MODULATE without alpha
    color.rgb = color.rgb * texelUNIT.rgb;
//@ GL_MODULATE GL_LUMINANCE_ALPHA | GL_MODULATE GL_INTENSITY | GL_MODULATE GL_RGBA

    // Unit UNIT, GL_MODULATE
    color = color * texelUNIT;
//@ GL_DECAL GL_RGB

    // Unit UNIT, GL_DECAL without alpha
    color.rgb = texelUNIT.rgb;
//@ GL_DECAL GL_RGBA

    // Unit UNIT, GL_DECAL
    color.rgb = color.rgb * (1.0 - texelUNIT.a) + texelUNIT.rgb * texelUNIT.a;
//@ GL_DECAL GL_ALPHA | GL_DECAL GL_LUMINANCE | GL_DECAL GL_LUMINANCE_ALPHA | GL_DECAL GL_INTENSITY

    // Unit UNIT, GL_DECAL with a format for which it is undefined: the colour is passed on.
//@ GL_BLEND GL_ALPHA

    // Unit UNIT, GL_BLEND with alpha alone
    color.a = color.a * texelUNIT.a;
//@ GL_BLEND GL_LUMINANCE | GL_BLEND GL_RGB

    // Unit UNIT, GL_BLEND without alpha
    color.rgb = color.rgb * (1.0 - texelUNIT.rgb) + environmentColorUNIT.rgb * texelUNIT.rgb;
//@ GL_BLEND GL_LUMINANCE_ALPHA | GL_BLEND GL_RGBA

    // Unit UNIT, GL_BLEND
    color.rgb = color.rgb * (1.0 - texelUNIT.rgb) + environmentColorUNIT.rgb * texelUNIT.rgb;
    color.a = color.a * texelUNIT.a;
//@ GL_BLEND GL_INTENSITY

    // Unit UNIT, GL_BLEND with intensity, which blends alpha too
    color = color * (1.0 - texelUNIT) + environmentColorUNIT * texelUNIT;
//@ GL_ADD GL_ALPHA

    // Unit UNIT, GL_ADD with alpha alone
    color.a = color.a * texelUNIT.a;
//@ GL_ADD GL_LUMINANCE | GL_ADD GL_RGB

    // Unit UNIT, GL_ADD without alpha
    color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);
//@ GL_ADD GL_LUMINANCE_ALPHA | GL_ADD GL_RGBA

    // Unit UNIT, GL_ADD, which multiplies alpha
    color.rgb = min(color.rgb + texelUNIT.rgb, 1.0);
    color.a = color.a * texelUNIT.a;
//@ GL_ADD GL_INTENSITY

    // Unit UNIT, GL_ADD with intensity, which adds alpha too
    color = min(color + texelUNIT, 1.0);

#!/usr/bin/python3
"""Makes the image files of the lessons: ./make_images.py. They are part of the repository, so nobody needs to.

Pillow draws and encodes TGA, ImageMagick 6 encodes BMP and the blocks of DDS files: programs other than Texplorer, so
that the lessons show files as they are found. Three things are done by hand, as no encoder does them: header fields of the BMP
that say 0, DXT3's alpha, and chains that are cut short.

Every picture is a grid of cells with a letter for the row, from the top, and a number for the column, so that one sees
at once what is upside down or mirrored, and which part of it a coordinate names.
"""

import colorsys
import pathlib
import struct
import subprocess
import tempfile

from PIL import Image, ImageDraw, ImageFont

HERE = pathlib.Path(__file__).parent
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"
HEADER = 128  # bytes of a DDS file before its first level


def grid(side, cells):
    """Warm at the left, cold at the right, dark below."""
    image = Image.new("RGB", (side, side))
    draw = ImageDraw.Draw(image)
    cell = side // cells
    font = ImageFont.truetype(FONT, cell * 5 // 8)
    for row in range(cells):
        for column in range(cells):
            hue = 0.02 + 0.62 * column / (cells - 1)
            value = 0.95 - 0.5 * row / (cells - 1)
            fill = tuple(round(255 * each) for each in colorsys.hsv_to_rgb(hue, 0.6 if (row + column) % 2 else 0.8, value))
            left, top = column * cell, row * cell
            draw.rectangle((left, top, left + cell - 1, top + cell - 1), fill)
            draw.text((left + cell / 2, top + cell / 2), "ABCDEFGH"[row] + str(column + 1), anchor="mm", font=font,
                      fill="white" if value < 0.7 else "black")
    for line in range(cells):
        draw.line((line * cell, 0, line * cell, side), "white")
        draw.line((0, line * cell, side, line * cell), "white")
    return image


def disc(image):
    """The same with alpha: 255 in the middle of the picture, falling to 0 at its edges."""
    side = image.width
    alpha = Image.new("L", image.size)
    for y in range(side):
        for x in range(side):
            away = ((x + 0.5 - side / 2) ** 2 + (y + 0.5 - side / 2) ** 2) ** 0.5 / (side / 2)
            alpha.putpixel((x, y), max(0, min(255, round(255 * (1 - away) / 0.45))))
    image = image.copy()
    image.putalpha(alpha)
    return image


def magick(image, name, *options):
    """A file as ImageMagick writes it, as bytes."""
    with tempfile.TemporaryDirectory() as folder:
        image.save(f"{folder}/in.png")
        subprocess.run(["convert", f"{folder}/in.png", "-strip", *options, f"{folder}/{name}"], check=True)
        return bytearray(pathlib.Path(folder, name).read_bytes())


def dds(image, compression):
    """One level, with the top row first, as DirectX has it: ImageMagick turns nothing over."""
    return magick(image, "out.dds", "-define", f"dds:compression={compression}", "-define", "dds:cluster-fit=true",
                  "-define", "dds:weight-by-alpha=false", "-define", "dds:mipmaps=0")


def block_bytes(side, size):
    return max(1, (side + 3) // 4) ** 2 * size


def cut(file, side, size, levels):
    """The first levels of a square DDS file, and a header that says so."""
    struct.pack_into("<I", file, 28, levels)
    if levels == 1:
        flags, = struct.unpack_from("<I", file, 8)
        struct.pack_into("<I", file, 8, flags & ~0x20000)  # DDSD_MIPMAPCOUNT
        struct.pack_into("<I", file, 108, 0x1000)  # DDSCAPS_TEXTURE alone
    return file[:HEADER + sum(block_bytes(side >> level, size) for level in range(levels))]


def chain(image, compression, levels):
    """Each level is the mean of the image. ImageMagick's own levels of 4 x 4 texels and fewer have other colours."""
    file = dds(image, compression)
    for level in range(1, levels):
        size = tuple(max(1, side >> level) for side in image.size)
        file += dds(image.resize(size, Image.BOX), compression)[HEADER:]
    struct.pack_into("<I", file, 28, levels)
    flags, = struct.unpack_from("<I", file, 8)
    struct.pack_into("<I", file, 8, flags | 0x20000)  # DDSD_MIPMAPCOUNT
    struct.pack_into("<I", file, 108, 0x401008)  # DDSCAPS_COMPLEX, TEXTURE, MIPMAP
    return file


def dxt3(image, levels):
    """DXT5's colours with 4 bits of alpha for each texel, two a byte, the left one in the low bits."""
    file = chain(image, "dxt5", levels)
    file[84:88] = b"DXT3"
    at = HEADER
    for level in range(levels):
        side = max(1, image.width >> level)
        alpha = image.getchannel("A").resize((side, side), Image.BOX)
        for top in range(0, side, 4):
            for left in range(0, side, 4):
                rows = []
                for y in range(4):
                    bits = [(alpha.getpixel((min(left + x, side - 1), min(top + y, side - 1))) * 15 + 127) // 255
                            for x in range(4)]
                    rows.append(sum(bit << 4 * x for x, bit in enumerate(bits)))
                struct.pack_into("<4H", file, at, *rows)
                at += 16
    return file


def write(name, content):
    (HERE / name).write_bytes(content)
    print(f"{name}: {len(content)} bytes")


def bitmaps():
    # 24 bits, 54 bytes of header, and 0 where the tutorial's loader guesses: the data's position at 10, the
    # image's size at 34.
    bmp = magick(grid(96, 6), "out.bmp", "-type", "TrueColor", "-define", "bmp:format=bmp3")
    assert len(bmp) == 54 + 96 * 96 * 3
    struct.pack_into("<I", bmp, 10, 0)
    struct.pack_into("<I", bmp, 34, 0)
    write("textured-cube/uv.bmp", bmp)
    # 63 texels of 3 bytes are 189, padded to 192.
    odd = magick(grid(64, 4).crop((0, 0, 63, 64)), "out.bmp", "-type", "TrueColor", "-define", "bmp:format=bmp3")
    assert len(odd) == 54 + 192 * 64
    struct.pack_into("<I", odd, 34, 0)
    write("textured-cube/padded.bmp", odd)
    # Bit 5 of byte 17 says that the top row is first; the other file has the same rows from the bottom. ImageMagick
    # 6 gets this bit wrong, so they are Pillow's.
    for name, orientation, bits in ("top-down", 1, 0x20), ("bottom-up", -1, 0):
        file = HERE / f"textured-cube/{name}.tga"
        grid(64, 4).save(file, orientation=orientation)
        content = file.read_bytes()
        assert content[2] == 2 and len(content) < 13000 and content[17] & 0x20 == bits  # not run-length coded
        print(f"{file.name}: {len(content)} bytes")


def surfaces():
    write("textured-cube/uv.dds", chain(grid(96, 6), "dxt1", 6))  # down to 3 x 3
    picture = grid(128, 4)
    write("dds/dxt1.dds", chain(picture, "dxt1", 8))
    write("dds/dxt3.dds", dxt3(disc(picture), 8))
    write("dds/dxt5.dds", chain(disc(picture), "dxt5", 8))
    write("dds/turned.dds", chain(picture.transpose(Image.FLIP_TOP_BOTTOM), "dxt1", 8))
    write("dds/no-mipmaps.dds", cut(chain(picture, "dxt1", 8), 128, 8, 1))
    write("sizes/short-chain.dds", cut(chain(picture, "dxt1", 8), 128, 8, 4))
    # 8 x 2 texels: 16 bytes, then three blocks of 8 for 4 x 1, 2 x 1 and 1 x 1.
    ramp = Image.new("RGB", (8, 2))
    for x in range(8):
        for y in range(2):
            ramp.putpixel((x, y), (255 - 32 * x, 32 * x, 200 * y))
    low = chain(ramp, "dxt1", 4)
    assert len(low) == HEADER + 16 + 8 + 8 + 8, len(low)
    write("sizes/8x2.dds", low)
    # One block: four rows, each of one colour, from red at the top to blue below.
    block = Image.new("RGB", (4, 4))
    for y in range(4):
        for x in range(4):
            block.putpixel((x, y), (255 - 85 * y, 0, 85 * y))
    one = dds(block, "dxt1")
    assert len(one) == HEADER + 8, len(one)
    write("blocks/one-block.dds", one)


bitmaps()
surfaces()

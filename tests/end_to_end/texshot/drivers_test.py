"""texshot drivers and --context: every available context, also queried by ctypes; drivers that crash, hang or are not
drivers; and that a scene gives the same picture with every context."""

import ctypes
import json
import multiprocessing
import os
import pathlib
import signal
import subprocess
import time
import unittest

from PIL import Image

from texshot import TEXSHOT, Texshot, results, single, texshot

# The built modules: one for each library of contexts.
MODULES = {path.stem.removeprefix("texshot_")
           for path in (pathlib.Path(TEXSHOT).resolve().parents[1] / "lib/texplorer").glob("texshot_*.so")}
ASSETS = pathlib.Path(__file__).resolve().parents[3] / "assets/scenes"
GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS, GL_SHADING_LANGUAGE_VERSION = 0x1F00, 0x1F01, 0x1F02, 0x1F03, 0x8B8C
GL_MAX_TEXTURE_SIZE, GL_MAX_TEXTURE_MAX_ANISOTROPY = 0x0D33, 0x84FF

# A driver as a vendor of libglvnd's EGL: its entry point ends the caller in different ways.
VENDOR = """
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
int __egl_Main(unsigned version, const void *exports, void *vendor, void *imports) {
    (void)version; (void)exports; (void)vendor; (void)imports;
    %s
    return 0;
}
"""
FATES = {  # the body of the entry point: the reported error
    'fputs("no such\\033 GPU\\n", stderr); abort();': "the driver crashed: SIGABRT, aborted; the last that it printed "
                                                      'is "no such\\u001b GPU"',
    "raise(SIGSEGV);": "the driver crashed: SIGSEGV, segmentation fault",
    "_exit(3);": "the driver ended its process with status 3",
    "for (;;) pause();": "the driver hangs: there is no answer after 2 s",
    "": "EGL has no EGL_MESA_platform_surfaceless",
}


def say(gl):
    """The current context's own description."""
    gl.glGetString.restype = ctypes.c_char_p
    gl.glGetString.argtypes = [ctypes.c_uint]
    gl.glGetIntegerv.argtypes = [ctypes.c_uint, ctypes.c_void_p]
    gl.glGetFloatv.argtypes = [ctypes.c_uint, ctypes.c_void_p]
    size, anisotropy = ctypes.c_int(), ctypes.c_float()
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, ctypes.byref(size))
    gl.glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, ctypes.byref(anisotropy))
    text = {name: gl.glGetString(number).decode() for name, number in (
        ("vendor", GL_VENDOR), ("driver", GL_RENDERER), ("version", GL_VERSION),
        ("shadingLanguage", GL_SHADING_LANGUAGE_VERSION), ("extensions", GL_EXTENSIONS))}
    return {**text, "extensions": text["extensions"].split(), "maxTextureSize": size.value,
            "maxAnisotropy": anisotropy.value}


def ask_osmesa(_):
    osmesa = ctypes.CDLL("libOSMesa.so.8")
    osmesa.OSMesaCreateContextExt.restype = ctypes.c_void_p
    context = osmesa.OSMesaCreateContextExt(0x1908, 24, 0, 0, None)
    pixels = ctypes.create_string_buffer(64)
    assert osmesa.OSMesaMakeCurrent(ctypes.c_void_p(context), pixels, 0x1401, 4, 4)
    return say(osmesa)


def ask_egl(device):
    """`device`: None is the surfaceless platform, which Mesa calls 0x31DD; devices are 0x313F."""
    egl = ctypes.CDLL("libEGL.so.1")
    for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglGetProcAddress"):
        getattr(egl, name).restype = ctypes.c_void_p
    native = ctypes.c_void_p()
    if device is not None:
        query = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(
            egl.eglGetProcAddress(b"eglQueryDevicesEXT"))
        devices, count = (ctypes.c_void_p * 16)(), ctypes.c_int()
        assert query(16, devices, ctypes.byref(count))
        if device >= count.value:
            return None
        native = ctypes.c_void_p(devices[device])
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD if device is None else 0x313F, native, None))
    if not egl.eglInitialize(display, None, None):
        return None
    assert egl.eglBindAPI(0x30A2)
    config, count = ctypes.c_void_p(), ctypes.c_int()
    wanted = (ctypes.c_int * 5)(0x3033, 1, 0x3040, 8, 0x3038)  # pbuffers, OpenGL
    assert egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count)) and count.value
    context = ctypes.c_void_p(egl.eglCreateContext(display, config, None, None))
    assert egl.eglMakeCurrent(display, None, None, context)
    return say(ctypes.CDLL("libOpenGL.so.0"))


def apart(ask, what):
    with multiprocessing.get_context("fork").Pool(1) as pool:
        return pool.apply(ask, (what,))


class Drivers(Texshot):
    def drivers(self, *arguments, **options):
        result = texshot("drivers", "--json", *arguments, **options)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return {each["context"]: each for each in results(result.stdout)}

    def test_every_context_says_what_ctypes_hears_from_it(self):
        found = self.drivers("--extensions")
        expected = {}
        if "osmesa" in MODULES:
            expected["osmesa"] = apart(ask_osmesa, None)
        if "egl" in MODULES:
            expected["egl:surfaceless"] = apart(ask_egl, None)
            devices = [name for name in found if name.startswith("egl:") and name != "egl:surfaceless"]
            self.assertEqual(devices, [f"egl:{number}" for number in range(len(devices))])
            for number, name in enumerate(devices):
                expected[name] = apart(ask_egl, number)
            self.assertIsNone(apart(ask_egl, len(devices)))
        self.assertEqual(list(found), list(expected))
        for name, heard in expected.items():
            with self.subTest(name):
                self.assertEqual(found[name]["usable"], heard is not None)
                if heard:
                    self.assertEqual({key: found[name][key] for key in heard}, heard)
                    self.assertEqual(found[name]["extensionCount"], len(heard["extensions"]))
                    self.assertEqual(found[name]["s3tc"], "GL_EXT_texture_compression_s3tc" in heard["extensions"])
                    self.assertEqual(found[name]["profile"], "compatibility")

    def test_the_list_is_for_people_as_well(self):
        said = self.succeeds("drivers").decode()
        for name, each in self.drivers().items():
            self.assertIn(f"{name}\n  renderer        {each['driver']}\n", said)
            self.assertIn(f"  extensions      {each['extensionCount']}\n", said)
        self.assertNotIn("GL_EXT_texture_compression_s3tc", said)
        self.assertIn("\n    GL_EXT_texture_compression_s3tc\n", self.succeeds("drivers", "--extensions").decode())
        self.assertNotIn("extensions", next(iter(self.drivers().values())))
        said = self.succeeds("drivers", "--help").decode()
        for variable in ("GALLIUM_DRIVER", "LP_NUM_THREADS", "GALLIVM_PERF", "MESA_GL_VERSION_OVERRIDE"):
            self.assertIn(variable, said)

    def test_an_old_driver_and_a_core_profile_say_what_they_lack(self):
        for version, profile in (("1.4", "compatibility"), ("3.3FC", "core")):
            environment = {**os.environ, "MESA_GL_VERSION_OVERRIDE": version}
            for each in self.drivers(env=environment).values():
                with self.subTest(version=version, context=each["context"]):
                    self.assertEqual((each["usable"], each["profile"]), (False, profile))
                    self.assertIn("needs OpenGL 2.1", each["error"]["message"])
                    self.assertIn("llvmpipe", each["driver"])
            result = texshot("drivers", env=environment)
            self.assertEqual((result.returncode, result.stderr),
                             (1, b"texshot: Texplorer can't draw in any of these contexts\n"))
            self.assertIn("\n  not usable      ", result.stdout.decode())

    def test_a_wrong_context_is_refused(self):
        for word in ("EGL", "egl:", "egl:-1", "egl:1x", "egl:99999999999", "glx"):
            self.complains(2, f'--context: expected auto, osmesa, egl, egl:surfaceless or egl:N with the number of a '
                              f'device, found "{word}"', "shot", "--context", word, "-o", "-")
        result = texshot("shot", "-o", "-", env={**os.environ, "TEXPLORER_CONTEXT": "bogus"})
        self.assertEqual(result.returncode, 2)
        self.assertIn(b'texshot: TEXPLORER_CONTEXT: expected auto, ', result.stderr)
        unused = ("--context: has no effect here", "--context", "egl")
        self.notes(unused[0], "shot", "--size", "8x8", "--renderer", "reference", *unused[1:], "-o", "-")
        self.notes(unused[0], "probe", "--size", "8x8", "--at", "1,1", "--no-gl", *unused[1:])
        for module in {"osmesa", "egl"} - MODULES:
            self.complains(1, "this texshot was built without", "shot", "--context", module, "-o", "-")
        if "egl" in MODULES:
            self.complains(1, "egl:99: EGL has the devices 0 to ", "shot", "--context", "egl:99", "-o", "-")


class Contexts(Texshot):
    """With the same driver the pictures are the same."""

    SCENES = {
        "anisotropy": ("--set", "textures[0].minFilter=GL_LINEAR_MIPMAP_LINEAR", "--set", "textures[0].maxAnisotropy=8"),
        "compressed by the driver": ("--set", "textures[0].compression=driver"),
        **{name: (ASSETS / f"{name}.json",) for name in (
            "fog", "internal-formats", "nehe-bumps-1-unit", "seamless", "shadow-map", "teapot")},
    }

    def contexts(self):
        found = [each["context"] for each in results(self.succeeds("drivers", "--json"))
                 if each["usable"] and "llvmpipe" in each["driver"]]
        self.assertEqual({name.split(":")[0] for name in found}, MODULES)
        return found

    def test_a_scene_is_the_same_picture_in_each(self):
        contexts = self.contexts()
        for name, scene in self.SCENES.items():
            for renderer in ("fixed", "shader"):
                first = self.shot(*scene, "--renderer", renderer, "--size", "400x300")
                self.assertGreater(len(set(first.getdata())), 50)
                for context in contexts:
                    with self.subTest(name, renderer=renderer, context=context):
                        other = self.shot(*scene, "--renderer", renderer, "--size", "400x300", "--context", context)
                        self.assertIsNone(self.difference(first, other))

    def test_the_window_is_the_same_picture_in_each(self):
        """Draws into the context's own framebuffer: OSMesa's is memory, EGL's is a pbuffer."""
        for window in (("--size", "1280x800"), ("--size", "1920x1080", "--scale", "1.5", "--theme", "light", "--layout",
                                                "teacher", "--tab", "levels", "--renderer", "shader")):
            first = self.shot("--ui", *window)
            for context in self.contexts():
                with self.subTest(window, context=context):
                    self.assertIsNone(self.difference(first, self.shot("--ui", *window, "--context", context)))

    def test_the_variable_does_the_same_and_auto_is_osmesa_where_it_was_built(self):
        for context in self.contexts():
            loaded = self.libraries_of(TEXPLORER_CONTEXT=context)
            self.assertEqual("libOSMesa" in loaded, context == "osmesa")
            self.assertEqual("libEGL" in loaded, context != "osmesa")
        self.assertEqual("libOSMesa" in self.libraries_of(), "osmesa" in MODULES)

    def libraries_of(self, **environment):
        """The libraries that the dynamic linker loaded for a shot (ld.so(8))."""
        result = subprocess.run([TEXSHOT, "shot", "--size", "16x16", "-o", str(self.path / "out.png")], check=True,
                                env={**os.environ, "LD_DEBUG": "libs", **environment}, capture_output=True, timeout=120)
        return "\n".join(line for line in result.stderr.decode().splitlines() if "calling init" in line)

    def test_probe_and_conform_ask_the_context(self):
        probes = {self.succeeds("probe", "--at", "200,150", "--size", "400x300", "--json", "--context", context)
                  for context in self.contexts()}
        self.assertEqual(len(probes), 1)
        for context in self.contexts():
            report = single(self.succeeds("conform", "--feature", "wrap", "--scenes", "20", "--json", "--context",
                                              context))
            self.assertIn(f"--context {context}", report["command"])


@unittest.skipUnless("egl" in MODULES, "the others are those of OSMesa, in driver_test.py")
class BadDrivers(Texshot):
    """EGL's libraries are chosen by variables: the result is a picture or one sentence, never a signal."""

    def vendor(self, fate):
        """A variable that names an EGL vendor with this behaviour."""
        source, library, description = (self.path / f"vendor.{end}" for end in ("c", "so", "json"))
        source.write_text(VENDOR % fate)
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
        description.write_text(json.dumps({"file_format_version": "1.0.0", "ICD": {"library_path": str(library)}}))
        return {**os.environ, "__EGL_VENDOR_LIBRARY_FILENAMES": str(description)}

    def mesa_driver(self, fate):
        """Mesa's EGL is there, and the driver that it loads has this behaviour."""
        source, library = self.path / "driver.c", self.path / "swrast_dri.so"
        source.write_text("#include <stdlib.h>\n#include <unistd.h>\n"
                          "__attribute__((constructor)) static void fate(void) { %s }\n" % fate)
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
        return {**os.environ, "LIBGL_DRIVERS_PATH": str(self.path)}

    def listed(self, environment, *arguments):
        result = texshot("drivers", "--json", *arguments, env=environment)
        self.assertIn(result.returncode, (0, 1))
        contexts = {each["context"]: each for each in results(result.stdout)}
        for name, each in contexts.items():
            self.assertEqual(each["usable"], name == "osmesa", name)
        contexts.pop("osmesa", None)
        return contexts

    def refused(self, environment, *arguments):
        """The error of a failing call, in one sentence."""
        result = texshot(*arguments, env=environment)
        said = result.stderr.decode()
        self.assertEqual((result.returncode, result.stdout), (1, b""), said)
        self.assertRegex(said, r"\Atexshot: [^\n]+\n\Z")
        return said

    def test_a_vendor_that_crashes_hangs_or_is_none_is_a_line_of_the_list(self):
        for fate, sentence in FATES.items():
            with self.subTest(fate):
                contexts = self.listed(self.vendor(fate), "--time-limit", "2")
                self.assertTrue(contexts)
                for each in contexts.values():
                    self.assertIn(sentence, each["error"]["message"])

    def test_a_driver_of_mesa_that_crashes_is_a_line_for_each_context(self):
        for fate, sentence in (("abort();", "the driver crashed: SIGABRT, aborted"),
                               ("_exit(0);", "the driver ended its process with status 0")):
            with self.subTest(fate):
                contexts = self.listed(self.mesa_driver(fate))
                self.assertIn("egl:surfaceless", contexts)
                for each in contexts.values():
                    self.assertIn(sentence, each["error"]["message"])

    def test_to_draw_with_them_is_a_sentence(self):
        picture = ["shot", "--context", "egl", "-o", self.path / "out.png"]
        for fate, sentence in FATES.items():
            with self.subTest(fate):
                said = self.refused(self.vendor(fate), *picture)
                self.assertIn(sentence.replace("2 s", "20 s").removesuffix('"').split("; ")[0], said)
        crashing = self.mesa_driver("abort();")
        for call in (picture, [*picture, "--ui"], ["conform", "--scenes", "30", "--context", "egl:surfaceless"]):
            with self.subTest(call=call):
                self.assertIn("the driver crashed: SIGABRT", self.refused(crashing, *call))

    def test_ctrl_c_ends_whom_a_driver_holds(self):
        program = subprocess.Popen([TEXSHOT, "drivers"], env=self.vendor("for (;;) pause();"), stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        children = pathlib.Path(f"/proc/{program.pid}/task/{program.pid}/children")
        held = []
        while not held:
            self.assertIsNone(program.poll())
            held = [number for number in children.read_text().split()
                    if "vendor.so" in pathlib.Path(f"/proc/{number}/maps").read_text()]
            time.sleep(0.01)
        program.send_signal(signal.SIGINT)
        _, said = program.communicate(timeout=60)
        self.assertEqual((program.returncode, said.decode()), (130, "texshot: interrupted; nothing was written\n"))
        deadline = time.monotonic() + 60
        while any(os.path.exists(f"/proc/{number}/exe") for number in held):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def test_variables_that_name_drivers_are_a_picture_or_a_sentence(self):
        for name, value, works in (
                ("GALLIUM_DRIVER", "llvmpipe", True), ("GALLIUM_DRIVER", "softpipe", True),
                ("GALLIUM_DRIVER", "", True), ("GALLIUM_DRIVER", "bogus", False), ("GALLIUM_DRIVER", "virpipe", False),
                ("GALLIUM_DRIVER", "swr", False), ("GALLIUM_DRIVER", "panfrost", False),
                ("LIBGL_ALWAYS_SOFTWARE", "1", True), ("LIBGL_ALWAYS_SOFTWARE", "bogus", True),
                ("MESA_LOADER_DRIVER_OVERRIDE", "bogus", None), ("MESA_LOADER_DRIVER_OVERRIDE", "zink", None),
                ("MESA_LOADER_DRIVER_OVERRIDE", "../../x", None), ("EGL_PLATFORM", "bogus", True),
                ("EGL_PLATFORM", "x11", True), ("EGL_PLATFORM", "gbm", True), ("DISPLAY", ":77", True),
                ("LIBGL_DRIVERS_PATH", "/nonexistent", False), ("LIBGL_DRIVERS_PATH", "relative\n", False),
                ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", False),
                ("__EGL_VENDOR_LIBRARY_FILENAMES", "/etc/passwd", False),
                ("MESA_GL_VERSION_OVERRIDE", "1.4", False), ("MESA_GL_VERSION_OVERRIDE", "3.0FC", False),
                ("MESA_GL_VERSION_OVERRIDE", "2.1", True),
                ("MESA_EXTENSION_OVERRIDE", "-GL_ARB_framebuffer_object", False)):
            for how in ([], ["--ui"]):
                with self.subTest(f"{name}={value}", how=how):
                    picture = self.path / "out.png"
                    picture.unlink(missing_ok=True)
                    result = texshot("shot", "--context", "egl", *how, "-o", picture, env={**os.environ, name: value})
                    ours = [line for line in result.stderr.decode().splitlines() if line.startswith("texshot: ")]
                    self.assertIn(result.returncode, (0, 1), result.stderr)
                    if works is not None:
                        self.assertEqual(result.returncode == 0, works, result.stderr)
                    self.assertEqual(len(ours), result.returncode)
                    if result.returncode == 0:
                        Image.open(picture).load()
                    else:
                        self.assertFalse(picture.exists())


if __name__ == "__main__":
    unittest.main()

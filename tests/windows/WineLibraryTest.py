"""The libraries visibility and dat for Windows: built with MinGW as an engine author does, static and as DLLs, and the examples under Wine.

Usage: WineLibraryTest.py SOURCE EXAMPLES [unittest arguments]. SOURCE: the project, with build/windows-deps (tools/windows-deps). EXAMPLES:
the directory of the same examples for Linux.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE, EXAMPLES = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
TOOLCHAIN = SOURCE / "cmake/mingw-toolchain.cmake"
PROGRAMS = {"flood": [], "house": [], "records": ["example.dat"]}
SECONDS = 600


def run(*command, env=None, cwd=None):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=env, cwd=cwd, timeout=SECONDS)
    if done.returncode != 0:
        raise AssertionError(f"exit {done.returncode} of {' '.join(map(str, command))}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def compiler_folders():
    """The folders with DLLs of the compiler: the C++ library, and threads."""
    names = [run("x86_64-w64-mingw32-g++-posix", f"-print-file-name={name}").strip() for name in ("libstdc++-6.dll", "libwinpthread-1.dll")]
    return {pathlib.Path(name).resolve().parent for name in names}


class WineLibrary(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="limen für die Дом ")
        self.addCleanup(folder.cleanup)
        self.work = pathlib.Path(folder.name)

    def install(self, shared):
        build, prefix = self.work / "build", self.work / "prefix"
        run("cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", "--toolchain", TOOLCHAIN, "-DLIMEN_PARTS=visibility;dat", "-DLIMEN_UNITE=ON",
            "-DLIMEN_BUILD_TESTS=OFF", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2", f"-DBUILD_SHARED_LIBS={'ON' if shared else 'OFF'}")
        run("cmake", "--build", build)
        for component in ("visibility", "dat"):
            run("cmake", "--install", build, "--prefix", prefix, "--component", component)
        return prefix

    def check_examples(self, shared):
        prefix = self.install(shared)
        build = self.work / "examples"
        config, = prefix.rglob("limen-config.cmake")
        run("cmake", "-S", SOURCE / "examples", "-B", build, "-G", "Ninja", "--toolchain", TOOLCHAIN, f"-Dlimen_DIR={config.parent}",
            f"-DCMAKE_EXE_LINKER_FLAGS={'' if shared else '-static'}")
        run("cmake", "--build", build, "--target", *PROGRAMS)
        folders = [prefix / "bin", *compiler_folders()] if shared else []
        env = dict(os.environ, WINEPREFIX=str(self.work / "wine"), WINEDEBUG="-all", WINEDLLOVERRIDES="mscoree,mshtml=", LC_ALL="C.UTF-8", HOME=str(self.work),
                   WINEPATH=";".join("Z:" + str(path).replace("/", "\\") for path in folders))
        env.pop("DISPLAY", None)
        self.addCleanup(subprocess.run, ["wineserver", "-k"], env=env, check=False)
        for program, arguments in PROGRAMS.items():
            ours = run("wine", build / f"{program}.exe", *arguments, env=env, cwd=self.work)
            linux = run(EXAMPLES / program, *arguments, cwd=self.work)
            self.assertEqual(ours, linux, program)
            self.assertGreater(len(linux), 50, program)
        return prefix

    def test_static(self):
        self.check_examples(shared=False)

    def test_dlls_export_the_public_interface(self):
        prefix = self.check_examples(shared=True)
        listed = run("x86_64-w64-mingw32-nm", "-g", prefix / "lib/liblimen-visibility.dll.a")
        names = {line.split()[2] for line in listed.splitlines() if " T " in line}
        recorded = (SOURCE / "tests/install/c-names.txt").read_text().split()
        self.assertEqual(sorted(name for name in names if name.startswith("limen_")), recorded)
        self.assertEqual([name for name in names if "limen" not in name], [])


unittest.main()

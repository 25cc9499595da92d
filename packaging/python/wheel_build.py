"""Makes Python packages of rollcon, by the rules of PEP 517: pip calls build_wheel. It needs CMake, a compiler and what
docs/build.md names, and no other Python package, so that it works without a network.

As a program: wheel_build.py FOLDER writes the wheel there and says what its library links.
ROLLCON_CMAKE_ARGS: options for CMake, such as -DROLLCON_WITH_FFTW=OFF.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "bindings/python/rollcon"


def version_text():
    text = (ROOT / "include/rollcon.h").read_text(encoding="utf-8")
    return re.search(r'#define ROLLCON_VERSION_STRING "([^"]+)"', text).group(1)


def version():
    """As PEP 440 writes it: 1.0.0rc2."""
    return version_text().replace("-", "")


def metadata():
    return "\n".join([
        "Metadata-Version: 2.1", "Name: rollcon", f"Version: {version()}",
        "Summary: Frictional rolling contact of elastic bodies", "License: BSD-3-Clause", "Requires-Python: >=3.9",
        "Requires-Dist: numpy", "Provides-Extra: pictures", 'Requires-Dist: matplotlib; extra == "pictures"',
        "Description-Content-Type: text/markdown", "", (ROOT / "bindings/python/README.md").read_text(encoding="utf-8")])


def build_library(work):
    """The shared library, installed in a folder of its own; its path."""
    if not shutil.which("cmake"):
        raise SystemExit("rollcon is built by CMake 3.25 or newer, which is not installed: docs/build.md")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DROLLCON_STATIC=OFF", "-DROLLCON_FORTRAN=OFF", "-DROLLCON_UNITY=ALL",
               "-DROLLCON_PRECOMPILE=ALL", "-DCMAKE_INSTALL_LIBDIR=lib",
               *shlex.split(os.environ.get("ROLLCON_CMAKE_ARGS", ""))]
    subprocess.run(["cmake", "-S", ROOT, "-B", work / "build", *generator, *options], check=True)
    subprocess.run(["cmake", "--build", work / "build", "--parallel", str(os.cpu_count() or 1)], check=True)
    subprocess.run(["cmake", "--install", work / "build", "--strip", "--prefix", work / "prefix"], check=True,
                   stdout=subprocess.DEVNULL)
    return work / "prefix"


def contents(prefix):
    """Names in the wheel and files."""
    files = {f"rollcon/{path.relative_to(PACKAGE).as_posix()}": path for path in sorted(PACKAGE.rglob("*"))
             if path.is_file() and (path.suffix == ".py" or path.name == "py.typed")}
    library = next(path for path in sorted((prefix / "lib").glob("librollcon*.so.*")) if path.is_symlink())
    files[f"rollcon/{library.name}"] = library.resolve()
    files["rollcon/share/rollcon/steel.rct"] = ROOT / "src/tables/steel.rct"
    return files


def tag():
    """The library is of this machine; it is no extension of Python, so any version serves."""
    return "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def write_wheel(folder, files):
    name = f"rollcon-{version()}"
    info = f"{name}.dist-info"
    texts = {f"{info}/METADATA": metadata(), f"{info}/LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8"),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: rollcon\nRoot-Is-Purelib: false\nTag: {tag()}\n"}
    path = pathlib.Path(folder) / f"{name}-{tag()}.whl"
    rows = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for inside, data in [(k, v.read_bytes()) for k, v in files.items()] + [(k, v.encode()) for k, v in texts.items()]:
            entry = zipfile.ZipInfo(inside, (2026, 1, 1, 0, 0, 0))
            entry.external_attr, entry.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            rows.append(f"{inside},sha256={digest},{len(data)}")
        rows.append(f"{info}/RECORD,,")
        wheel.writestr(zipfile.ZipInfo(f"{info}/RECORD", (2026, 1, 1, 0, 0, 0)), "\n".join(rows) + "\n")
    return path.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as work:
        return write_wheel(wheel_directory, contents(build_library(pathlib.Path(work))))


def build_sdist(sdist_directory, config_settings=None):
    """The sources as scripts/tarball.sh packs them, with the file that pip asks for."""
    name = f"rollcon-{version()}"
    with tempfile.TemporaryDirectory() as work:
        packed_as = pathlib.Path(work) / f"rollcon-{version_text()}"
        subprocess.run(["bash", ROOT / "scripts/tarball.sh", work], check=True, stdout=subprocess.DEVNULL)
        with tarfile.open(next(pathlib.Path(work).glob("*.tar.*"))) as packed:
            packed.extractall(work)
        (packed_as / "PKG-INFO").write_text(metadata(), encoding="utf-8")
        with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as made:
            made.add(packed_as, name)
    return f"{name}.tar.gz"


def audit(wheel):
    """What the library in a wheel links, and the newest versions of the C and C++ libraries that it asks for."""
    with tempfile.TemporaryDirectory() as work:
        with zipfile.ZipFile(wheel) as opened:
            inside = next(n for n in opened.namelist() if "librollcon" in n)
            path = opened.extract(inside, work)
        said = subprocess.run(["objdump", "-p", path], check=True, capture_output=True, text=True).stdout
    needed = re.findall(r"NEEDED +(\S+)", said)
    newest = {}
    for family, number in re.findall(r"\b(GLIBCXX|GLIBC|CXXABI|GOMP|GCC)_([\d.]+)$", said, re.M):
        newest[family] = max(newest.get(family, ()), tuple(map(int, number.split("."))))
    return needed, {family: ".".join(map(str, number)) for family, number in sorted(newest.items())}


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / build_wheel(folder)
    needed, newest = audit(wheel)
    print(f"{wheel}: {wheel.stat().st_size} bytes")
    print("links, from the system:", " ".join(needed))
    print("newest symbols:", ", ".join(f"{family} {number}" for family, number in newest.items()))


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: Apache-2.0
"""Builds wheels with CMake (PEP 517), by the standard library alone: Debian 12 has no backend that runs CMake.

    pip install --no-build-isolation .                      # builds in build/pip
    pip install . --config-settings=build=FOLDER            # in another folder
    pip install . --config-settings=cmake=-DEPURA_WERROR=ON # with other options of CMake, separated by blanks
    pip install . --config-settings=installed=PREFIX        # on the epura that is installed there; no: on none

On an installed epura of this version, that of the program in PATH unless another one is named, only the module is built:
half a minute. Otherwise the wheel has the library, the projections and the importers beside the module.
`build_backend.py FOLDER` writes the metadata of an installed package, for CMake.
"""
from __future__ import annotations

import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path
from typing import Any, Dict, List, Optional

ROOT = Path(__file__).resolve().parent.parent
#: What the module needs at run time; importers that could not be built have no rules.
COMPONENTS = ("python", "library", "epura", "opencascade", "gltf", "3mf", "om")


def _project() -> Dict[str, Any]:
    project: Dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    version = re.search(r"project\(epura VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text("utf-8"))
    assert version is not None
    project["version"] = version[1]
    return project


def _name(project: Dict[str, Any]) -> str:
    return f"{project['name']}-{project['version']}"


def write_metadata(folder: Path) -> Path:
    """Writes epura-VERSION.dist-info into the folder; returns its path."""
    project = _project()
    info = folder / f"{_name(project)}.dist-info"
    info.mkdir(parents=True, exist_ok=True)
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {needed}" for needed in project["dependencies"]]
    for extra, needs in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}"] + [f"Requires-Dist: {needed}; extra == '{extra}'" for needed in needs]
    (info / "METADATA").write_text("\n".join(lines) + "\n", "utf-8")
    points = [f"[{group}]\n" + "".join(f"{name} = {target}\n" for name, target in entries.items())
              for group, entries in project["entry-points"].items()]
    (info / "entry_points.txt").write_text("\n".join(points), "utf-8")
    return info


def _tag() -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _package_in(prefix: Path) -> Optional[Path]:
    """The folder of the CMake package of an epura of this version, with what the module is built from."""
    for parts in sorted(prefix.glob("lib*/cmake/epura/_parts.py")) + sorted(prefix.glob("lib/*/cmake/epura/_parts.py")):
        version = parts.with_name("epura-config-version.cmake")
        if version.exists() and f'set(PACKAGE_VERSION "{_project()["version"]}")' in version.read_text("utf-8"):
            return parts.parent
    return None


def _installed(settings: Dict[str, Any]) -> Optional[Path]:
    """The package of the installed epura on which the module is to be built."""
    wanted = settings.get("installed", "")
    if wanted == "no":
        return None
    program = shutil.which("epura")
    prefix = Path(wanted) if wanted else Path(program).resolve().parent.parent if program else None
    package = _package_in(prefix) if prefix else None
    if wanted and package is None:
        raise SystemExit(f"epura: no epura {_project()['version']} with its headers is installed in {wanted}")
    return package


def _install(stage: Path, settings: Dict[str, Any]) -> None:
    """Builds, and installs what a wheel contains."""
    package = _installed(settings)
    build = Path(settings.get("build", ROOT / "build" / ("pip" if package is None else "pip-module"))).resolve()
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    options = settings.get("cmake", "").split()
    common = ["-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *launcher, *options,
              f"-DEPURA_PYTHON={sys.executable}", "-DEPURA_PYTHON_FOLDER=.", f"-DCMAKE_INSTALL_PREFIX={stage}"]
    if package is None:
        subprocess.run(["cmake", "-S", ROOT, *common, "-DEPURA_TESTS=OFF", "-DEPURA_DEBIAN=OFF",
                        "-DCMAKE_INSTALL_LIBDIR=epura/lib", "-DCMAKE_INSTALL_BINDIR=epura/bin",
                        "-DCMAKE_INSTALL_DATADIR=epura/share", "-DCMAKE_INSTALL_DOCDIR=epura/share/doc",
                        "-DCMAKE_INSTALL_MANDIR=epura/share/man"], check=True)
    else:
        print(f"epura: the module is built on the epura of {package}; --config-settings=installed=no builds all anew")
        subprocess.run(["cmake", "-S", ROOT / "python", *common, f"-Depura_DIR={package}"], check=True)
    subprocess.run(["cmake", "--build", build], check=True)
    for component in COMPONENTS if package is None else ("python",):
        subprocess.run(["cmake", "--install", build, "--component", component, "--strip"], check=True)
    if not (stage / "epura" / "__init__.py").exists():
        raise SystemExit("epura: the module was not built: install pybind11-dev and python3-dev, then try again")
    shutil.rmtree(stage / "epura" / "share", ignore_errors=True)
    # Wheels have no links: libraries get the names by which they are loaded.
    for link in [path for path in stage.rglob("*.so*") if path.is_symlink()]:
        link.resolve().replace(link)


def _write_wheel(stage: Path, wheel: Path, info: str) -> None:
    """A zip file with a record of its files."""
    record: List[str] = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(stage.rglob("*")):
            if not path.is_file():
                continue
            name, data = path.relative_to(stage).as_posix(), path.read_bytes()
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100755 if os.access(path, os.X_OK) else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}\n")
        archive.writestr(f"{info}/RECORD", "".join(record) + f"{info}/RECORD,,\n")


def build_wheel(wheel_directory: str, config_settings: Optional[Dict[str, Any]] = None,
                metadata_directory: Optional[str] = None) -> str:
    name = f"{_name(_project())}-{_tag()}.whl"
    with tempfile.TemporaryDirectory() as scratch:
        stage = Path(scratch)
        _install(stage, config_settings or {})
        info = write_metadata(stage)
        (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: epura\nRoot-Is-Purelib: false\nTag: {_tag()}\n")
        shutil.copy(ROOT / "LICENSE", info)
        _write_wheel(stage, Path(wheel_directory) / name, info.name)
    return name


def build_sdist(sdist_directory: str, config_settings: Optional[Dict[str, Any]] = None) -> str:
    """What git knows of."""
    name = _name(_project())
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    with tempfile.TemporaryDirectory() as scratch:
        metadata = write_metadata(Path(scratch)) / "METADATA"
        with tarfile.open(Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as archive:
            for path in filter(None, listed.split("\0")):
                archive.add(ROOT / path, f"{name}/{path}")
            archive.add(metadata, f"{name}/PKG-INFO")
    return f"{name}.tar.gz"


if __name__ == "__main__":
    write_metadata(Path(sys.argv[1]))

# Copyright (c) the rollcon authors. BSD-3-Clause.
from spack.package import *


class Rollcon(CMakePackage):
    """Frictional rolling contact of elastic bodies: C library with interfaces for Fortran and Python."""

    homepage = "https://RELEASES"
    url = "https://RELEASES/rollcon-1.0.0-rc2.tar.xz"
    license("BSD-3-Clause")

    # version("1.0.0-rc2", sha256="...")  when it is published

    variant("shared", default=True, description="Build the shared library")
    variant("fem", default=True, description="Finite-element bodies, by CHOLMOD (GPL)")
    variant("umfpack", default=True, description="UMFPACK (GPL) for the published procedures")
    variant("fftw", default=True, description="FFTW (GPL) for regular frames")
    variant("openmp", default=True, description="Loops on several threads")

    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("lapack")
    depends_on("suite-sparse", when="+fem")
    depends_on("suite-sparse", when="+umfpack")
    depends_on("fftw-api@3", when="+fftw")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("ROLLCON_SHARED", "shared"),
            self.define("ROLLCON_STATIC", "~shared" in self.spec),
            self.define_from_variant("ROLLCON_WITH_FEM", "fem"),
            self.define_from_variant("ROLLCON_WITH_CHOLMOD", "fem"),
            self.define_from_variant("ROLLCON_WITH_UMFPACK", "umfpack"),
            self.define_from_variant("ROLLCON_WITH_FFTW", "fftw"),
            self.define_from_variant("ROLLCON_WITH_OPENMP", "openmp"),
            self.define("ROLLCON_FORTRAN", False),  # shipped as source
        ]

"""The headers for Conan 2: conan create . ; a program requires pn-subdivision-3/VERSION."""
from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy


class PnSubdivision3(ConanFile):
    name = "pn-subdivision-3"
    version = "0.2.0"
    description = "Point-normal subdivision of curves and surfaces for CGAL"
    license = "LGPL-3.0-or-later"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"with_eigen": [True, False], "with_tbb": [True, False]}
    default_options = {"with_eigen": True, "with_tbb": False}
    exports_sources = "include/*", "LICENSE.*"
    no_copy_source = True

    def requirements(self):
        self.requires("cgal/[>=5.5 <7]", transitive_headers=True)
        if self.options.with_eigen:
            self.requires("eigen/[>=3.3 <4]", transitive_headers=True)
        if self.options.with_tbb:
            self.requires("onetbb/[>=2021]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def package_id(self):
        self.info.clear()

    def package(self):
        copy(self, "*", f"{self.source_folder}/include", f"{self.package_folder}/include")
        copy(self, "LICENSE.*", self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "PN_subdivision_3")
        self.cpp_info.set_property("cmake_target_name", "CGAL::PN_subdivision_3")
        if self.options.with_eigen:
            self.cpp_info.defines.append("CGAL_EIGEN3_ENABLED")
        if self.options.with_tbb:
            self.cpp_info.defines.append("CGAL_LINKED_WITH_TBB")

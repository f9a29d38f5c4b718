# cpack: one package with the libraries, headers, CMake files and the tool, as .tar.gz and .deb.
set(CPACK_PACKAGE_NAME "softshadows")
set(CPACK_PACKAGE_VENDOR "SoftShadows contributors")
set(CPACK_PACKAGE_CONTACT "SoftShadows contributors <softshadows@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR "TGZ;DEB")

# VTK's minor version is part of the binary interface; what the libraries need of Debian is found in
# them by dpkg-shlibdeps. Building against the package needs VTK's headers besides.
set(CPACK_DEBIAN_PACKAGE_SECTION "libdevel")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libvtk9-dev, xvfb, xauth, libgl1-mesa-dri")
if (SOFTSHADOWS_WRAP_PYTHON)
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3-vtk9")
endif ()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)

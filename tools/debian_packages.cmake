# `cpack` in a build folder makes Debian packages: the command line, the studio, the library with its headers, the Python module.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mirrorball)
set(CPACK_PACKAGE_VENDOR Mirrorball)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Mirrorball developers <developers@mirrorball.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_COMPONENTS_ALL cli library)

set(CPACK_DEBIAN_CLI_PACKAGE_NAME mirrorball)
set(CPACK_COMPONENT_CLI_DESCRIPTION "Materials with environment maps: the command line
 Converts, filters, renders and exports HDR light probes; needs no display.")
set(CPACK_DEBIAN_CLI_PACKAGE_DEPENDS "libegl1, libopengl0, libgl1-mesa-dri") # loaded when a picture is drawn

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libmirrorball-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Materials with environment maps: the library
 Static libraries, headers, and what find_package(mirrorball) finds.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "mirrorball (= ${PROJECT_VERSION}), pkg-config, libglm-dev, libopenexr-dev, nlohmann-json3-dev, \
libpng-dev, zlib1g-dev, libzstd-dev, libssl-dev, libsharp-dev, libfftw3-dev, libepoxy-dev, libegl-dev, libopencolorio-dev")

if(MIRRORBALL_STUDIO)
  list(APPEND CPACK_COMPONENTS_ALL studio)
  set(CPACK_DEBIAN_STUDIO_PACKAGE_NAME mirrorball-studio)
  set(CPACK_COMPONENT_STUDIO_DESCRIPTION "Materials with environment maps: the desktop tool
 Load a light probe, filter it for a material, see it on a model, export the maps.")
  set(CPACK_DEBIAN_STUDIO_PACKAGE_DEPENDS "mirrorball (= ${PROJECT_VERSION}), qt6-qpa-plugins, libqt6svg6")
endif()

if(MIRRORBALL_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-mirrorball)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Materials with environment maps: the Python module
 Probes, filters, scenes and exports as numpy arrays and values.")
  # The module is built for one minor version of Python.
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "mirrorball (= ${PROJECT_VERSION}), python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), \
python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/tools/debian_python/postinst;${PROJECT_SOURCE_DIR}/tools/debian_python/prerm")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/mirrorball RENAME copyright COMPONENT cli)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/mirrorball COMPONENT cli)
include(CPack)

vcpkg_download_distfile(ARCHIVE
  URLS "https://RELEASES/rollcon-${VERSION}.tar.xz"
  FILENAME "rollcon-${VERSION}.tar.xz"
  SHA512 0) # when it is published
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURES FEATURES
  fem ROLLCON_WITH_FEM
  fem ROLLCON_WITH_CHOLMOD
  fftw ROLLCON_WITH_FFTW)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "dynamic" SHARED)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "static" STATIC)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${FEATURES}
  -DROLLCON_SHARED=${SHARED} -DROLLCON_STATIC=${STATIC} -DROLLCON_WITH_UMFPACK=OFF -DROLLCON_FORTRAN=OFF
  -DROLLCON_PYTHON=OFF -DROLLCON_DOCS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/rollcon)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")

# The installable package: libraries, public headers and kernel texts, find_package(waterlight).
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY WATERLIGHT_LIBRARIES)
set(WATERLIGHT_COMPONENTS)
foreach(library IN LISTS libraries)
    get_target_property(component ${library} EXPORT_NAME)
    list(APPEND WATERLIGHT_COMPONENTS ${component})
    target_compile_features(${library} PUBLIC cxx_std_20)
endforeach()

install(TARGETS ${libraries} EXPORT waterlightTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(folder IN ITEMS gpu sim caustics export render scenarios test_kit)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/waterlight
        FILES_MATCHING PATTERN "*.hpp" PATTERN "kernels/*.glsl"
        PATTERN "shaders" EXCLUDE PATTERN "detail" EXCLUDE)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/waterlight)
install(EXPORT waterlightTargets NAMESPACE waterlight:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/waterlightConfig.cmake.in
    ${PROJECT_BINARY_DIR}/waterlightConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waterlightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waterlightConfig.cmake ${PROJECT_BINARY_DIR}/waterlightConfigVersion.cmake
    DESTINATION ${package_folder})

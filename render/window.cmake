# The window and what is drawn over its pictures: not part of the installed package, whose users bring their own.
find_package(PkgConfig REQUIRED)
find_package(glfw3 REQUIRED)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)

add_library(waterlight_window STATIC interface.cpp window.cpp)
target_include_directories(waterlight_window PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(waterlight_window
    PUBLIC waterlight::gpu waterlight::sim PkgConfig::IMGUI
    PRIVATE waterlight_flags glfw fmt::fmt)

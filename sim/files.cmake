# Surfaces from files: the one part of sim that needs VTK.
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore IOCore IOXMLParser)

waterlight_library(sim_files pvd_reader.cpp vti_reader.cpp vtk_xml.cpp)
target_link_libraries(waterlight_sim_files PRIVATE fmt::fmt VTK::CommonCore VTK::IOCore VTK::IOXMLParser)

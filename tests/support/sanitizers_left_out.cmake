# Tests that the sanitizers' presets leave out, by a label. Read by CTest once it knows the tests.
function(leave_out label area)
    foreach(test IN LISTS ARGN)
        set_tests_properties(${test} PROPERTIES LABELS "${area};${label}")
    endforeach()
endfunction()

# They bound the program's address space, of which a sanitizer takes terabytes for itself.
leave_out(not_under_sanitizers faults_test Faults.MemoryThatWillNotDoIsForetoldWithTheFigure)

# They bound the size of its files. The thread sanitizer maps a file of its own when it starts, and dies of a bus error
# where that file may not be whole.
leave_out(not_under_tsan check_test Check.ARunThatFailsLeavesItsChecksWithoutAValue)
leave_out(not_under_tsan faults_test Faults.AFileThatMayNotGrowStopsTheRun)
leave_out(not_under_tsan sweep_test Sweep.AFileThatMayNotGrowStopsIt)

# Hundreds of millions of updates of cells in one thread or in loops that shorter tests run as well: ten minutes and more
# under the thread sanitizer.
leave_out(not_under_tsan shallow_long_test
    ShallowLong.AMillionStepsKeepTheWater<float> ShallowLong.AMillionStepsKeepTheWater<double>)
foreach(scenario IN ITEMS conical_island_a conical_island_c monai_valley)
    foreach(law IN ITEMS MeetsItsChecksOnTheCpu MeetsItsChecksOnVulkanWithValidationSilent)
        leave_out(not_under_tsan shipped_scenarios_test
            "All/ShippedScenario.${law}/${scenario}  # GetParam() = ${scenario}")
    endforeach()
endforeach()

// tests/CMakeLists.txt compiles the headers of this program for all tests.

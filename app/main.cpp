#include "app/program.hpp"

int main(int argc, char** argv) { return poissonlab::program_main(argc, argv); }

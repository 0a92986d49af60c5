// The program: host/experiment has the command line, reports the report; they meet here only.
#include "experiment/command_line.hpp"
#include "reports/compare_runs.hpp"
#include "reports/report.hpp"

int main(int argc, char** argv)
{
    return poissonlab::run_command_line(argc, argv, poissonlab::write_report, poissonlab::compare_runs);
}

// The program: host/experiment has the command line, reports the report; they meet here only.
#include "app/command_line.hpp"
#include "reports/diff/compare_runs.hpp"
#include "reports/site/report.hpp"

int main(int argc, char** argv)
{
    return poissonlab::run_command_line(argc, argv, poissonlab::write_report, poissonlab::compare_runs);
}

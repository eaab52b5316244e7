// SPDX-License-Identifier: GPL-3.0-or-later

// The rule that core knows no widgets, kept by the linker: this program holds the whole of core
// and links Qt6::Gui alone, so an undefined QWidget symbol in core stops the build. Running it
// tells the other half: that no library of core's brought Qt Widgets along.

#include <cstdio>
#include <fstream>
#include <string>

int main()
{
    std::ifstream mappedFiles("/proc/self/maps");
    for (std::string line; std::getline(mappedFiles, line);) {
        if (line.find("Qt6Widgets") != std::string::npos) {
            std::fprintf(stderr, "core brings Qt Widgets along: %s\n", line.c_str());
            return 1;
        }
    }
    return 0;
}

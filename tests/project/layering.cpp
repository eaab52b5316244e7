// SPDX-License-Identifier: GPL-3.0-or-later

// The linker keeps the rule that core knows no widgets: this program contains all of core and links
// Qt6::Gui alone, so an undefined QWidget symbol in core breaks the build. Running it checks the
// other half: that no library of core's pulled Qt Widgets in.

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

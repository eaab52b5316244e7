// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"
#include "core/grade/try/programrun.h"
#include "core/grade/try/supervisor.h"

#include <vector>

namespace pixelplumb {

class WorkingFolder;

/// Owns what a supervisor's start points to: words, paths and files in the form that system calls
/// need.
class ProgramStart {
public:
    /// In the sandbox, or, with a folder, in that folder.
    ProgramStart(const StudentProgram &student, const QByteArray &input,
                 const ProgramLimits &limits, const WorkingFolder *folder);
    Q_DISABLE_COPY_MOVE(ProgramStart)

    bool isReady() const { return m_isReady; } ///< otherwise errno says why not
    /// Without pipes. Points into this object.
    const SupervisedStart &plan() const { return m_plan; }

private:
    /// Ends with a null pointer; without words it is a null pointer.
    class WordList {
    public:
        WordList() = default;
        explicit WordList(const QStringList &words);
        ArgumentPointers pointers() const
        {
            return m_pointers.empty() ? nullptr : m_pointers.data();
        }

    private:
        std::vector<QByteArray> m_words;
        std::vector<char *> m_pointers;
    };

    Descriptor m_input, m_filterFile;
    QByteArray m_folder;
    WordList m_command, m_environment, m_removal;
    sock_fprog m_filter = {};
    SupervisedStart m_plan;
    bool m_isReady = false;
};

} // namespace pixelplumb

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programrun.h"
#include "core/grade/supervisor.h"

#include <vector>

namespace pixelplumb {

/// Holds what a supervisor's start points to: words, paths and limits as system calls want them.
class ProgramStart {
public:
    ProgramStart(const StudentProgram &student, const QString &folder, const ProgramLimits &limits);
    Q_DISABLE_COPY_MOVE(ProgramStart)

    /// Without descriptors. It points into this.
    const SupervisedStart &plan() const { return m_plan; }

private:
    /// Ends with a null pointer.
    class WordList {
    public:
        explicit WordList(const QStringList &words);
        char *const *pointers() const { return m_pointers.data(); }

    private:
        std::vector<QByteArray> m_words;
        std::vector<char *> m_pointers;
    };

    QByteArray m_file, m_folder, m_folderOptions, m_userMap, m_groupMap;
    WordList m_arguments, m_environment;
    SupervisedStart m_plan;
};

} // namespace pixelplumb

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programstart.h"

#include "core/grade/try/programcommand.h"
#include "core/grade/try/programuser.h"
#include "core/grade/try/syscallfilter.h"
#include "core/grade/try/workingfolder.h"

#include <QFile>

#include <sys/mman.h>

#include <cerrno>

namespace pixelplumb {

namespace {

/// A file in memory: unlike a pipe it needs no feeding, whether it is read or not.
Descriptor fileOf(const QByteArray &content)
{
    Descriptor file(memfd_create("input", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    qsizetype done = 0;
    while (file.isOpen() && done < content.size()) {
        const ssize_t written = ::write(file.number(), content.constData() + done,
                                        std::size_t(content.size() - done));
        if (written <= 0)
            return Descriptor();
        done += written;
    }
    lseek(file.number(), 0, SEEK_SET);
    fcntl(file.number(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL);
    return file;
}

/// Whether it is a program or a script with #!: the tools that start it would run any other file as
/// a shell script. Unreadable files are not checked.
bool canBeStarted(const QString &program)
{
    QFile file(program);
    if (!file.open(QIODevice::ReadOnly))
        return true;
    const QByteArray beginning = file.read(4);
    return beginning.startsWith("#!") || beginning == "\177ELF";
}

QStringList environmentIn(const QString &folder)
{
    return {u"PATH=/usr/local/bin:/usr/bin:/bin"_s, u"LC_ALL=C.UTF-8"_s, u"HOME="_s + folder,
            u"TMPDIR="_s + folder};
}

} // namespace

ProgramStart::WordList::WordList(const QStringList &words)
{
    for (const QString &word : words)
        m_words.push_back(QFile::encodeName(word));
    for (QByteArray &word : m_words)
        m_pointers.push_back(word.data());
    m_pointers.push_back(nullptr);
}

ProgramStart::ProgramStart(const StudentProgram &student, const QByteArray &input,
                           const ProgramLimits &limits, const WorkingFolder *folder)
    : m_input(fileOf(input))
{
    const ProgramUser user = ProgramUser::ofNextRun();
    const QByteArray &filter = syscallFilter();
    if (folder) {
        m_folder = QFile::encodeName(folder->path());
        m_command = WordList(limitedCommand(student, limits, user));
        m_removal = WordList(folder->removal());
        // The kernel does not write to it.
        m_filter.filter = reinterpret_cast<sock_filter *>(const_cast<char *>(filter.constData()));
        m_filter.len = static_cast<unsigned short>(filter.size() / qsizetype(sizeof(sock_filter)));
        m_plan.removal = m_removal.pointers();
        m_plan.filter = filter.isEmpty() ? nullptr : &m_filter;
        m_plan.makesFolder = true;
        m_plan.folderOwner = user.id;
        m_isReady = m_input.isOpen();
    } else {
        m_filterFile = fileOf(filter);
        m_folder = "/";
        m_command = WordList(sandboxedCommand(student, limits, user, m_filterFile.number()));
        m_plan.passedOn = m_filterFile.number();
        m_isReady = m_input.isOpen() && m_filterFile.isOpen();
    }
    if (!canBeStarted(student.path)) {
        m_isReady = false;
        errno = ENOEXEC;
    }
    m_environment = WordList(environmentIn(folder ? folder->path() : sandboxFolder()));
    m_plan.command = m_command.pointers();
    m_plan.environment = m_environment.pointers();
    m_plan.folder = m_folder.constData();
    m_plan.input = m_input.number();
}

} // namespace pixelplumb

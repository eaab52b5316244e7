// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/processes.h"

#include <QDir>
#include <QFile>

#include <unistd.h>

namespace pixelplumb {

using namespace Qt::StringLiterals;

int processesWith(const QByteArray &word)
{
    int count = 0;
    const QDir processes(u"/proc"_s);
    for (const QString &process : processes.entryList(QDir::Dirs)) {
        QFile file(u"/proc/%1/cmdline"_s.arg(process));
        if (file.open(QIODevice::ReadOnly) && file.readAll().split('\0').contains(word))
            ++count;
    }
    return count;
}

QByteArray unusualSeconds()
{
    static int each = 0;
    return QByteArray::number(1000 + ++each) + '.' + QByteArray::number(getpid());
}

} // namespace pixelplumb

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/promisednames.h"

#include "tests/support/sourcetree.h"

#include <QRegularExpression>

namespace pixelplumb {

namespace {

/// The kind of object and the name in a line.
QRegularExpressionMatch promiseOf(const QString &line)
{
    static const QRegularExpression promise(
        QStringLiteral("^(widget|action|dialog) ([A-Za-z]\\w*)$"));
    return promise.match(line);
}

QStringList lines()
{
    return textInTree(QStringLiteral("tests/data/object_names.txt"))
        .split(u'\n', Qt::SkipEmptyParts);
}

QString wordFor(PromisedObject object)
{
    switch (object) {
    case PromisedObject::Widget:
        return QStringLiteral("widget");
    case PromisedObject::Action:
        return QStringLiteral("action");
    case PromisedObject::Dialog:
        return QStringLiteral("dialog");
    }
    return {};
}

} // namespace

QStringList promisedNames(PromisedObject object)
{
    QStringList names;
    for (const QString &line : lines()) {
        const QRegularExpressionMatch promise = promiseOf(line);
        if (promise.captured(1) == wordFor(object))
            names += promise.captured(2);
    }
    return names;
}

QStringList unreadPromises()
{
    QStringList unread;
    for (const QString &line : lines()) {
        if (!line.startsWith(u'#') && !promiseOf(line).hasMatch())
            unread += line;
    }
    return unread;
}

} // namespace pixelplumb

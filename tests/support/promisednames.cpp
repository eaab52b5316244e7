// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/promisednames.h"

#include "tests/support/sourcetree.h"

#include <QRegularExpression>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// The kind of object and the name in a line.
QRegularExpressionMatch promiseOf(const QString &line)
{
    static const QRegularExpression promise(u"^(widget|action|dialog) ([A-Za-z]\\w*)$"_s);
    return promise.match(line);
}

QStringList lines()
{
    return textInTree(u"tests/data/object_names.txt"_s).split(u'\n', Qt::SkipEmptyParts);
}

QString wordFor(PromisedObject object)
{
    switch (object) {
    case PromisedObject::Widget:
        return u"widget"_s;
    case PromisedObject::Action:
        return u"action"_s;
    case PromisedObject::Dialog:
        return u"dialog"_s;
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

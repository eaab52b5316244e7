// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMutex>
#include <QSet>
#include <QTranslator>

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

/// A made-up language: every text of the window in brackets, and longer by a third. A text without
/// brackets has not come through tr().
class PseudoLanguage : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *sourceText, const char *, int) const override
    {
        if (QByteArray(context) != "core" && !QByteArray(context).startsWith("pixelplumb::"))
            return {}; // Qt's own, such as the names of keys
        const QString text = QString::fromUtf8(sourceText);
        const QMutexLocker locker(&m_mutex); // background jobs translate too
        m_asked += QString::fromUtf8(context) + u": "_s + text;
        return u'[' + text + QString(std::max<qsizetype>(1, text.size() / 3), u'~') + u']';
    }

    /// The translated texts, named as in TranslatedText: "pixelplumb::ViewMenu: T&ruth".
    QSet<QString> asked() const
    {
        const QMutexLocker locker(&m_mutex);
        return m_asked;
    }

private:
    mutable QMutex m_mutex;
    mutable QSet<QString> m_asked;
};

} // namespace pixelplumb

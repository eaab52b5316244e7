// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/translationfile.h"

#include "tests/support/sourcetree.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

/// Reads the <message> at the reader's position.
TranslatedText messageIn(QXmlStreamReader &xml)
{
    TranslatedText text;
    text.counts = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source")) {
            text.source = xml.readElementText();
        } else if (xml.name() != QLatin1String("translation")) {
            xml.skipCurrentElement();
        } else {
            text.state = xml.attributes().value(QLatin1String("type")).toString();
            if (!text.counts)
                text.forms += xml.readElementText();
            while (text.counts && xml.readNextStartElement())
                text.forms += xml.readElementText();
        }
    }
    return text;
}

} // namespace

QList<TranslatedText> textsOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&file);
    QList<TranslatedText> texts;
    QString context;
    while (!xml.atEnd()) {
        if (!xml.readNext() || !xml.isStartElement())
            continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            texts += messageIn(xml);
            texts.back().context = context;
        }
    }
    return xml.hasError() ? QList<TranslatedText>() : texts;
}

QStringList translationFiles()
{
    QStringList paths;
    const QDir folder(resource(u"/translations"_s));
    for (const QString &name : folder.entryList({u"pixelplumb_*.ts"_s}))
        paths += folder.filePath(name);
    return paths;
}

} // namespace pixelplumb

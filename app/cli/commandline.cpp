// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"

#include "app/cli/console.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

constexpr QChar minusSign(0x2212);

/// QCommandLineParser reads "-3" as an option, so it is given a minus sign (U+2212) instead.
QStringList withProtectedNumbers(const QStringList &arguments)
{
    static const QRegularExpression negativeNumber(u"^-(?=[0-9.])"_s);
    QStringList words = arguments;
    return words.replaceInStrings(negativeNumber, QString(minusSign));
}

QString asWritten(QString word)
{
    if (word.startsWith(minusSign))
        word[0] = u'-';
    return word;
}

QString dashed(const QString &option) { return QString(option.size() == 1 ? 1 : 2, u'-') + option; }

/// A list of names with their dashes; a single letter is no abbreviation: --x.
QString dashedAmong(const QStringList &names, const QString &name)
{
    return names.size() == 1 ? u"--"_s + name : dashed(name);
}

QString usageOf(const Positional &positional)
{
    switch (positional.presence) {
    case Positional::Presence::Required:
        return positional.name;
    case Positional::Presence::Optional:
        return u'[' + positional.name + u']';
    case Positional::Presence::AnyNumber:
        return u'[' + positional.name + u"...]"_s;
    case Positional::Presence::Several:
    case Positional::Presence::Command:
        break;
    }
    return positional.name + u"..."_s;
}

} // namespace

CommandLine::CommandLine(const Command &command, std::vector<Positional> positionals)
    : m_name(command.name)
    , m_summary(command.summary)
    , m_positionals(std::move(positionals))
{
    m_parser.setApplicationDescription(m_summary);
    for (const Positional &positional : m_positionals)
        m_parser.addPositionalArgument(positional.name, positional.meaning);
    addOption({{u"h"_s, u"help"_s}, u"Show this help."_s});
}

void CommandLine::addOption(const QCommandLineOption &option)
{
    m_onceOnly.push_back(option.names());
    addRepeatedOption(option);
}

void CommandLine::addRepeatedOption(const QCommandLineOption &option)
{
    m_optionNames += option.names();
    m_options.append(option);
    m_parser.addOption(option);
}

void CommandLine::addJsonOption() { addOption({u"json"_s, u"Print JSON."_s}); }

void CommandLine::parse(const QStringList &arguments)
{
    const bool parsed = m_parser.parse(QStringList{QCoreApplication::applicationName()}
                                       + withProtectedNumbers(arguments));
    if (m_parser.isSet(u"help"_s)) {
        printHelp();
        throw Ended{ExitCode::Done};
    }
    if (!parsed)
        refuse(m_parser.unknownOptionNames().isEmpty() ? m_parser.errorText() : unknownOption());
    refuseRepeatedOption();
    refuseEmptyOption();
    const QStringList positionals = m_parser.positionalArguments();
    const auto expected = qsizetype(m_positionals.size());
    const auto presence
        = [this](qsizetype place) { return m_positionals[std::size_t(place)].presence; };
    const auto mayBeLeftOut = [&](qsizetype place) {
        return presence(place) == Positional::Presence::Optional
            || presence(place) == Positional::Presence::AnyNumber;
    };
    if (positionals.size() < expected && !mayBeLeftOut(positionals.size())) {
        const Positional &missing = m_positionals[std::size_t(positionals.size())];
        refuse(u"%1 is missing: %2"_s.arg(missing.name, missing.meaning));
    }
    const auto last = expected > 0 ? presence(expected - 1) : Positional::Presence::Required;
    const bool isList
        = last == Positional::Presence::Several || last == Positional::Presence::AnyNumber;
    const bool takesMore = isList || last == Positional::Presence::Command;
    const qsizetype filled = isList ? positionals.size() : std::min(positionals.size(), expected);
    for (qsizetype place = 0; place < filled; ++place) {
        const Positional &positional = m_positionals[std::size_t(std::min(place, expected - 1))];
        if (positionals[place].isEmpty())
            refuse(u"%1 is empty: %2"_s.arg(positional.name, positional.meaning));
    }
    if (positionals.size() > expected && !takesMore)
        refuse(u"unexpected argument “%1”"_s.arg(argument(expected)));
}

QString CommandLine::value(const QString &option) const
{
    return asWritten(m_parser.value(option));
}

QString CommandLine::argument(qsizetype index) const { return arguments().value(index); }

QStringList CommandLine::arguments() const
{
    QStringList words;
    for (const QString &word : m_parser.positionalArguments())
        words.append(asWritten(word));
    return words;
}

void CommandLine::refuseRepeatedOption() const
{
    const QStringList found = m_parser.optionNames();
    for (const QStringList &names : m_onceOnly) {
        QStringList written;
        for (const QString &name : found) {
            if (names.contains(name))
                written.append(dashedAmong(names, name));
        }
        if (written.size() < 2)
            continue;
        // Empty for an option without a value.
        const QStringList values = m_parser.values(names.front());
        for (qsizetype i = 0; i < values.size(); ++i)
            written[i] += u' ' + asWritten(values[i]);
        refuse(u"%1; expected %2 once"_s.arg(written.join(u" and "_s),
                                             dashedAmong(names, names.back())));
    }
}

void CommandLine::refuseEmptyOption() const
{
    const QStringList found = m_parser.optionNames();
    for (const QCommandLineOption &option : m_options) {
        for (const QString &name : option.names()) {
            if (found.contains(name) && m_parser.values(name).contains(QString()))
                refuse(u"%1 is empty; expected its %2"_s.arg(dashedAmong(option.names(), name),
                                                             option.valueName()));
        }
    }
}

QString CommandLine::unknownOption() const
{
    const QString name = m_parser.unknownOptionNames().constFirst();
    const QString closest = closestTo(name, m_optionNames);
    const QString text = u"unknown option %1"_s.arg(dashed(name));
    return closest.isEmpty() ? text : text + u"; did you mean %1?"_s.arg(dashed(closest));
}

void CommandLine::printHelp() const
{
    QStringList words = {QCoreApplication::applicationName(), m_name, u"[options]"_s};
    for (const Positional &positional : m_positionals)
        words.append(usageOf(positional));
    // The parser begins its help with the program's path; this usage line names the command.
    const QString help = m_parser.helpText();
    const QString usage = u"Usage: "_s + words.join(u' ');
    printLines((usage + help.sliced(help.indexOf(u'\n'))).trimmed().split(u'\n'));
}

} // namespace pixelplumb::cli

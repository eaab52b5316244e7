// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/console.h"
#include "core/scene/text/result.h"

#include <QCommandLineParser>

#include <optional>
#include <vector>

namespace pixelplumb::cli {

/// A row of the table of commands.
struct Command {
    QString name; ///< "render"
    QString summary; ///< one line
    ExitCode (*run)(const Command &command, const QStringList &arguments);
};

/// A word that follows the command.
struct Positional {
    enum class Presence {
        Required,
        Optional,
        Several, ///< at least one
        AnyNumber, ///< or none
        Command, ///< a program and its arguments, which may be empty
    };

    QString name; ///< "SCENE"
    QString meaning;
    /// All but required ones stand last.
    Presence presence = Presence::Required;
};

/// The words after a command: options, and the positional arguments that the command names. What
/// is wrong with them is told with the word in question.
class CommandLine {
public:
    CommandLine(const Command &command, std::vector<Positional> positionals);

    void addOption(const QCommandLineOption &option); ///< may be given once
    void addRepeatedOption(const QCommandLineOption &option); ///< may be repeated
    void addJsonOption();
    /// Ends the command where help was asked for, or the words are wrong.
    void parse(const QStringList &arguments);

    bool asksForJson() const { return isSet(u"json"_s); }
    bool isSet(const QString &option) const { return m_parser.isSet(option); }
    /// Negative numbers are values, not options.
    QString value(const QString &option) const;
    /// Every value of a repeated option.
    QStringList values(const QString &option) const { return m_parser.values(option); }
    /// The positional argument at a place, empty where an optional one is left out; negative
    /// numbers are arguments, not options.
    QString argument(qsizetype index) const;
    QStringList arguments() const;

    const QString &command() const { return m_name; }

private:
    QString unknownOption() const;
    void refuseRepeatedOption() const; ///< of those that may be given once
    void refuseEmptyOption() const; ///< an option whose value is empty
    void printHelp() const;

    QString m_name;
    QString m_summary;
    std::vector<Positional> m_positionals;
    QStringList m_optionNames;
    QList<QCommandLineOption> m_options;
    std::vector<QStringList> m_onceOnly; ///< the names of each option that may stand once
    QCommandLineParser m_parser;
};

/// Every command, in the order in which help lists them.
const std::vector<Command> &commands();

} // namespace pixelplumb::cli

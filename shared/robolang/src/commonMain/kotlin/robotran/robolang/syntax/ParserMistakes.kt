package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.TIME_UNITS
import robotran.robolang.words.isBlank
import robotran.robolang.words.lowercaseKeyword
import robotran.robolang.words.written

/** Reports an error in the line of [reader]. */
internal fun DiagnosticSink.report(
    reader: LineReader,
    code: DiagnosticCode,
    range: SourceRange,
    message: String,
    fix: SourceFix? = null,
) {
    report(code, range, reader.textOf(range), message, fix)
}

/** Reports that one of [words] is missing; the next word counts as a misspelling of it if it is similar. */
internal fun DiagnosticSink.reportMissingWord(
    reader: LineReader,
    code: DiagnosticCode,
    words: List<String>,
    message: (suggestion: String?) -> String,
) {
    if (reportsDeclaredName(reader)) return
    val typed = reader.next?.takeIf { it.kind == TokenKind.WORD }
    val meant = typed?.let { suggestionIn(vocabulary, it.text, words) }
    val fix = when {
        typed != null && meant != null -> SourceFix(typed.range, meant)
        typed == null && words.size == 1 -> SourceFix(reader.gap, " " + words.single())
        else -> null
    }
    report(reader, code, typed?.range ?: reader.gap, message(meant?.let { vocabulary.written(it) }), fix)
}

/** Reports a name that contains a sign or begins with a digit; [start] is its start. */
internal fun DiagnosticSink.reportMalformedName(reader: LineReader, start: SourceRange) {
    val end = reader.line.text.drop(start.column - 1).indexOfFirst { isBlank(it) || it in "=()," }
    val range = if (end < 0) {
        reader.restRange.copy(column = start.column)
    } else {
        start.copy(endColumn = start.column + end)
    }
    report(reader, DiagnosticCode.MALFORMED_NAME, range, messages.malformedName(reader.quotable(range)))
}

/** A keyword declared as a name is reported there, not on each line that uses it. */
internal fun forgiveTakenWords(lines: List<ScannedLine>, diagnostics: DiagnosticSink) {
    val taken = diagnostics.takenWords
    if (taken.isEmpty()) return
    val declaring = taken.values.flatten().toSet()
    val using = lines.filter { line -> line.tokens.any { it.keyword != null && lowercaseKeyword(it.text) in taken } }
    diagnostics.forgive(using.mapTo(mutableSetOf()) { it.number } - declaring)
}

/**
 * After a number: reports the next word if it looks like a unit but is none of [units]. Leaves anything else to the
 * caller.
 */
internal fun DiagnosticSink.reportWrongUnit(reader: LineReader, units: List<Keyword>) {
    val word = reader.next?.takeIf { it.kind == TokenKind.WORD } ?: return
    val meant = meantUnit(word, units, vocabulary)
    if (meant == null && !isUnit(word)) return
    reportUnit(reader, word, units, meant)
}

/** Reports a `wait` without a valid unit. */
internal fun DiagnosticSink.reportNoTimeUnit(reader: LineReader, duration: Expression) {
    val word = reader.next?.takeIf { it.kind == TokenKind.WORD }
    if (isCondition(duration)) {
        val gap = reader.first.range.let { it.copy(column = it.endColumn) }
        val message = messages.missingWord(lowercaseKeyword(reader.first.text), Keyword.UNTIL.text, null)
        report(reader, DiagnosticCode.MISSING_WORD, gap, message, SourceFix(gap, " " + Keyword.UNTIL.text))
    } else if (word == null) {
        val fix = SourceFix(reader.gap, " " + Keyword.SECONDS.text)
        report(
            reader,
            DiagnosticCode.MISSING_TIME_UNIT,
            reader.gap,
            messages.missingTimeUnit(reader.quotable(duration.range)),
            fix,
        )
    } else {
        reportUnit(reader, word, TIME_UNITS)
    }
}

/** Whether [expression] is clearly a condition, not a number. */
private fun isCondition(expression: Expression): Boolean = when (expression) {
    is Expression.BooleanLiteral -> true

    is Expression.Sense -> {
        expression.sense is Sense.Button || expression.sense == Sense.LeftBumper ||
            expression.sense == Sense.RightBumper
    }

    is Expression.Unary -> expression.operator == UnaryOperator.NOT
    is Expression.Binary -> !expression.operator.isArithmetic
    is Expression.Brackets -> isCondition(expression.inner)
    else -> false
}

/** Reports [word] where one of [units] is expected. */
internal fun DiagnosticSink.reportUnit(
    reader: LineReader,
    word: Token,
    units: List<Keyword>,
    meant: Keyword? = meantUnit(word, units, vocabulary),
) {
    if (reportsDeclaredName(reader)) return
    val command = lowercaseKeyword(reader.first.text)
    val message = messages.wrongUnit(
        command,
        shortened(word.text),
        units.map {
            vocabulary.text(it)
        },
        meant?.let { vocabulary.text(it) },
    )
    report(reader, DiagnosticCode.WRONG_UNIT, word.range, message, meant?.let { SourceFix(word.range, it.text) })
}

/** Reports extra text after a complete command. */
internal fun DiagnosticSink.expectEndOfLine(reader: LineReader) {
    val extra = reader.next ?: return
    val space = SourceRange(reader.line.number, reader.gap.column, extra.range.column)
    if (extra.keyword in Keyword.COMMANDS && extra.keyword != Keyword.ROBOT && reader.first.keyword != Keyword.END) {
        val indentation = reader.line.text.substring(0, reader.first.range.column - 1)
        val fix = SourceFix(space, "\n" + indentation)
        report(reader, DiagnosticCode.SEVERAL_COMMANDS, extra.range, messages.severalCommands(extra.text), fix)
    } else if (!reportsDeclaredName(reader) && !reportsUnknownName(reader)) {
        val rest = reader.restRange
        val message = messages.extraWords(reader.quotable(rest), reader.quotable(reader.readRange))
        report(reader, DiagnosticCode.EXTRA_WORDS, rest, message, SourceFix(space.copy(endColumn = rest.endColumn), ""))
    }
}

internal fun DiagnosticSink.reportExtraEnd(reader: LineReader) {
    report(reader, DiagnosticCode.EXTRA_END, reader.first.range, messages.extraEnd())
}

internal fun DiagnosticSink.reportNesting(reader: LineReader, keyword: Token) {
    report(
        reader,
        DiagnosticCode.NESTED_TOO_DEEPLY,
        keyword.range,
        messages.nestedTooDeeply(RobolangLimits.NESTED_BLOCKS),
    )
}

/** Reports each block that lacks its `end`, with a fix that puts one at the indentation of the block's first line. */
internal fun reportMissingEnds(lacking: List<MissingEnd>, lines: List<ScannedLine>, diagnostics: DiagnosticSink) {
    for ((opener, endBefore) in lacking) {
        val indentation = lines[opener.range.line - 1].text.substring(0, opener.range.column - 1)
        val fix = if (endBefore == null) {
            val column = lines.last().text.length + 1
            SourceFix(SourceRange(lines.size, column, column), "\n" + indentation + Keyword.END.text)
        } else {
            SourceFix(SourceRange(endBefore, 1, 1), indentation + Keyword.END.text + "\n")
        }
        val message = diagnostics.messages.missingEnd(lowercaseKeyword(opener.text))
        diagnostics.report(DiagnosticCode.MISSING_END, opener.range, opener.text, message, fix)
    }
}

package robotran.robolang.syntax

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.KINDS
import robotran.robolang.words.Keyword
import robotran.robolang.words.OPENERS
import robotran.robolang.words.SETTINGS
import robotran.robolang.words.SIDES
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.isDigit
import robotran.robolang.words.lowercaseKeyword
import robotran.robolang.words.written

/** Everything a line can begin with; two-word commands also without their space, a common typo. */
private val BEGINNINGS: List<String> =
    Keyword.COMMANDS.map { it.text } + listOf(
        "pen down",
        "pen up",
        "turn left",
        "turn right",
        "start forward",
        "clear screen",
        "reset timer",
        "else if",
        "repeat forever",
    )

/** Keywords from the middle of a command, with the start of that command. */
private val BEGINNINGS_OF: Map<Keyword, String> = mapOf(
    Keyword.LEFT to "turn left",
    Keyword.RIGHT to "turn right",
    Keyword.DOWN to "pen down",
    Keyword.UP to "pen up",
    Keyword.TURNING to "start turning",
    Keyword.FOREVER to "repeat forever",
    Keyword.WHILE to "repeat while",
    Keyword.UNTIL to "repeat until",
)

/** Words that begin a line in other languages. */
private val BEGINNINGS_ELSEWHERE: Map<String, String> = mapOf(
    "int" to "var",
    "let" to "var",
    "set" to "var",
    "double" to "var",
    "boolean" to "var",
    "void" to "procedure",
    "def" to "procedure",
    "elif" to "else if",
    "endif" to "end",
    "endwhile" to "end",
    "endfor" to "end",
    "endrepeat" to "end",
    "fi" to "end",
    "done" to "end",
    "loop" to "repeat forever",
    "sleep" to "wait",
    "print" to "show",
    "println" to "show",
    "exit" to "halt",
    "move" to "forward",
)

/** The effect of an unknown line on the blocks around it. */
internal enum class BlockEffect { NONE, MAY_OPEN, CLOSES }

/** Reports that the line does not begin with a command, and suggests one. */
internal fun DiagnosticSink.reportNoCommand(reader: LineReader, routineNames: Set<String>): BlockEffect {
    val word = reader.first
    val letters = lettersOfCommandWithNumber(word, vocabulary)
    when {
        word.kind != TokenKind.WORD -> reportNoWord(reader)
        !isDeclaration(word, vocabulary) && reportsAssignedName(reader) -> Unit
        lowercaseKeyword(word.text) in routineNames -> reportMissingBrackets(reader)

        letters != null -> {
            reportMissingSpace(reader, word, letters)
            if (vocabulary.keyword(letters) in OPENERS) return BlockEffect.MAY_OPEN
        }

        isSetting(reader) -> {
            report(reader, DiagnosticCode.SETTING_OUTSIDE_ROBOT, reader.restRange, messages.settingOutsideRobot())
        }

        word.keyword?.beginsValue == true && word.keyword !in SIDES -> reportValueAsCommand(reader, word.range)

        reader.peek(1)?.keyword == Keyword.BUMPER -> {
            reportValueAsCommand(reader, word.range.copy(endColumn = checkNotNull(reader.peek(1)).range.endColumn))
        }

        else -> return reportUnknownCommand(reader, word)
    }
    return BlockEffect.NONE
}

/** Whether the line is one of the header. */
internal fun isSetting(reader: LineReader): Boolean = when (reader.first.keyword) {
    Keyword.LIGHT, Keyword.COLOUR, Keyword.SOUND -> reader.peek(1)?.keyword == Keyword.SENSOR
    Keyword.SONAR -> reader.peek(1)?.keyword == Keyword.ON
    Keyword.BRICK -> reader.peek(1)?.keyword in KINDS
    else -> false
}

/** Whether the line may be one of the header, with a mistake, rather than one that uses a name. */
internal fun maybeSetting(reader: LineReader): Boolean =
    reader.first.keyword in SETTINGS && reader.peek(1)?.kind !in NAME_ENDS

private val NAME_ENDS = setOf(TokenKind.ASSIGN, TokenKind.OPEN_BRACKET, TokenKind.OPEN_LIST)

private fun DiagnosticSink.reportValueAsCommand(reader: LineReader, range: SourceRange) {
    report(reader, DiagnosticCode.UNKNOWN_COMMAND, range, messages.valueAsCommand(reader.quotable(range)))
}

private fun DiagnosticSink.reportUnknownCommand(reader: LineReader, word: Token): BlockEffect {
    val meant =
        BEGINNINGS_OF[word.keyword] ?: BEGINNINGS_ELSEWHERE[lowercaseKeyword(word.text)]
            ?: suggestionIn(vocabulary, word.text, BEGINNINGS)
    val fix = meant?.let { SourceFix(word.range, it) }
    report(
        reader,
        DiagnosticCode.UNKNOWN_COMMAND,
        word.range,
        messages.unknownCommand(shortened(word.text), meant?.let { vocabulary.written(it) }),
        fix,
    )
    return when {
        meant == Keyword.END.text -> BlockEffect.CLOSES
        meant == null || Vocabulary.ENGLISH.keyword(meant.substringBefore(' ')) in OPENERS -> BlockEffect.MAY_OPEN
        else -> BlockEffect.NONE
    }
}

/** Whether [word] is meant to begin a declaration. */
private fun isDeclaration(word: Token, vocabulary: Vocabulary): Boolean =
    lowercaseKeyword(word.text) in BEGINNINGS_ELSEWHERE || suggestionIn(vocabulary, word.text, DECLARING) != null

private val DECLARING = listOf(Keyword.VAR.text, Keyword.CONST.text)

private fun DiagnosticSink.reportNoWord(reader: LineReader) {
    val first = reader.first
    if (first.kind == TokenKind.DIVIDE) {
        report(
            reader,
            DiagnosticCode.UNKNOWN_CHARACTER,
            first.range,
            messages.commentBegins(),
            SourceFix(first.range, "//"),
        )
    } else {
        report(reader, DiagnosticCode.MISSING_COMMAND, first.range, messages.missingCommand())
    }
}

/** Reports a call without brackets; the text after the name belongs between them. */
private fun DiagnosticSink.reportMissingBrackets(reader: LineReader) {
    val word = reader.first
    val rest = reader.restRange.copy(column = word.range.endColumn)
    val fix = SourceFix(rest, "(${reader.textOf(rest).trim()})")
    report(
        reader,
        DiagnosticCode.MISSING_BRACKETS,
        word.range,
        messages.missingBracketsOfCall(shortened(word.text)),
        fix,
    )
}

/** `forward` of `forward20`. */
private fun lettersOfCommandWithNumber(word: Token, vocabulary: Vocabulary): String? {
    val letters = word.text.trimEnd { isDigit(it) }
    return letters.takeIf { it.length < word.text.length && vocabulary.keyword(it) in Keyword.COMMANDS }
}

private fun DiagnosticSink.reportMissingSpace(reader: LineReader, word: Token, letters: String) {
    val number = word.text.substring(letters.length)
    val gapColumn = word.range.column + letters.length
    val fix = SourceFix(SourceRange(word.range.line, gapColumn, gapColumn), " ")
    report(reader, DiagnosticCode.MISSING_SPACE, word.range, messages.missingSpace(letters, shortened(number)), fix)
}

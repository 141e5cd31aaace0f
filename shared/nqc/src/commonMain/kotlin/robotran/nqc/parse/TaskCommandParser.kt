package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.Statement

/** Reads `start name;` and `stop name;`, also as other languages write them. */
internal class TaskCommandParser(private val reader: TokenReader, private val names: NameResolver) {
    private val sink = reader.sink

    /** Reads the command that begins with [keyword]. */
    fun command(keyword: Keyword): Statement {
        val word = reader.advance()
        val isInBrackets = reader.isSign("(") && reader.peek(1).kind == TokenKind.NAME && reader.peek(2).isSign(")")
        if (isInBrackets) return named(word, keyword)
        val name = reader.name()
        if (reader.isSign("(")) skipBrackets(word, name)
        reader.semicolon()
        return Statement.TaskCommand(name.text, keyword == Keyword.START, word.range.to(name.range), name)
    }

    /** Whether here begins what starts or stops a task elsewhere, such as `StartTask(drive);`. */
    fun isCommand(): Boolean {
        val word = reader.token
        val name = if (reader.peek(1).isSign("(")) reader.peek(2) else reader.peek(1)
        return word.kind == TokenKind.NAME && word.text in COMMANDS && !names.isCallable(word.text) &&
            names.isTask(name.text)
    }

    /** Reads what starts or stops a task elsewhere, see [isCommand]. */
    fun command(): Statement {
        val word = reader.advance()
        return named(word, COMMANDS.getValue(word.text))
    }

    /** Reads the name of a task, most often in brackets, behind [word] that means [keyword]. */
    private fun named(word: Token, keyword: Keyword): Statement {
        val isInBrackets = reader.accept("(")
        val name = reader.name()
        if (reader.accept("(")) reader.closing(")")
        if (isInBrackets) reader.closing(")")
        val right = "${keyword.text} ${name.text}"
        val range = word.range.to(reader.previous.range)
        val isTyped = listOf(word, name, reader.previous).all { it.macro == null && it.range.line == word.range.line }
        val message = if (word.keyword == null) {
            sink.messages.taskCommand(word.text, right)
        } else {
            sink.messages.taskWithBrackets(word.text, name.text)
        }
        sink.report(NqcDiagnosticCode.UNEXPECTED_TOKEN, range, message, SourceFix(range, right).takeIf { isTyped })
        reader.semicolon()
        return Statement.TaskCommand(name.text, keyword == Keyword.START, range, name)
    }

    /** Skips the brackets of `start name();`, whatever is in them. */
    private fun skipBrackets(word: Token, name: Token) {
        val opening = reader.advance()
        val isEmpty = reader.isSign(")")
        while (reader.isInLineOf(opening) && ENDS.none { reader.isSign(it) }) reader.advance()
        reader.closing(")")
        val range = opening.range.to(reader.previous.range)
        val message = sink.messages.taskWithBrackets(word.text, name.text)
        val isTyped = opening.macro == null && range.endColumn > opening.range.endColumn
        val fix = SourceFix(range, "").takeIf { isEmpty && isTyped }
        sink.report(NqcDiagnosticCode.UNEXPECTED_TOKEN, range, message, fix)
    }

    private companion object {
        /** The calls of other languages. */
        val COMMANDS = mapOf(
            "StartTask" to Keyword.START,
            "startTask" to Keyword.START,
            "Start" to Keyword.START,
            "run" to Keyword.START,
            "StopTask" to Keyword.STOP,
            "stopTask" to Keyword.STOP,
            "Stop" to Keyword.STOP,
        )
        val ENDS = setOf(")", ";", "{", "}")
    }
}

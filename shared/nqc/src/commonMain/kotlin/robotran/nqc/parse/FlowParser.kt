package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Token
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Handler
import robotran.nqc.tree.Statement

/** Reads the statements that hold others: branches, loops, `monitor` and `acquire`. */
internal class FlowParser(
    private val reader: TokenReader,
    private val expressions: ExpressionParser,
    private val assignments: AssignmentParser,
    private val misspelled: MisspelledWords,
    private val statement: () -> Statement,
    private val block: () -> Statement,
) {
    private val sink = reader.sink
    private val layout = BodyLayout(reader)

    /** Reads a statement that begins with [keyword]; null if that begins none of these. */
    fun statement(keyword: Keyword): Statement? = when (keyword) {
        Keyword.IF -> branch()
        Keyword.WHILE -> withBody { condition, body, range -> Statement.While(condition, body, range) }
        Keyword.REPEAT -> withBody { count, body, range -> Statement.Repeat(count, body, range) }
        Keyword.SWITCH -> withBody { selector, body, range -> Statement.Switch(selector, body, range) }
        Keyword.DO -> doWhile()
        Keyword.FOR -> forLoop()
        Keyword.MONITOR -> monitor()
        Keyword.ACQUIRE -> acquire()
        else -> null
    }

    private fun accept(keyword: Keyword): Boolean {
        misspelled.correct()
        return reader.accept(keyword)
    }

    private fun withBody(make: (Expression, Statement, SourceRange) -> Statement): Statement {
        val word = reader.advance()
        val value = expressions.inBrackets()
        if (reader.peek(1).isSign("{")) warnOfEmptyBody(word)
        val body = layout.body(word, statement)
        return make(value, body, word.range.to(value.range))
    }

    private fun branch(): Statement {
        val word = reader.advance()
        val condition = expressions.inBrackets()
        warnOfEmptyBody(word)
        val then = layout.body(word, statement)
        val otherwise = when {
            accept(Keyword.ELSE) -> layout.body(reader.previous, statement)
            misspelled.correctElseIf() -> branch()
            else -> null
        }
        return Statement.If(condition, then, otherwise, word.range.to(condition.range))
    }

    /** Warns of a semicolon that ends the statement that begins with [word] before its body. */
    private fun warnOfEmptyBody(word: Token) {
        val semicolon = reader.token
        if (!semicolon.isSign(";") || semicolon.macro != null || word.macro != null) return
        val message = sink.messages.emptyBody(word.text)
        sink.report(NqcDiagnosticCode.EMPTY_BODY, semicolon.range, message, SourceFix(semicolon.range, ""))
    }

    private fun doWhile(): Statement {
        val word = reader.advance()
        val body = statement()
        if (!accept(Keyword.WHILE)) {
            reader.fail(NqcDiagnosticCode.UNEXPECTED_TOKEN, reader.gap, sink.messages.doWithoutWhile())
        }
        val condition = expressions.inBrackets()
        reader.semicolon()
        return Statement.DoWhile(body, condition, word.range)
    }

    private fun forLoop(): Statement {
        val word = reader.advance()
        reader.opening("(")
        if (reader.isKeyword(Keyword.INT)) {
            reader.fail(NqcDiagnosticCode.DECLARATION_IN_FOR, reader.token.range, sink.messages.declarationInFor())
        }
        val first = if (reader.isSign(";")) null else assignments.statement()
        reader.semicolon()
        val condition = if (reader.isSign(";")) null else expressions.expression()
        reader.semicolon()
        val step = if (reader.isSign(")")) null else assignments.statement()
        reader.closing(")")
        if (reader.peek(1).isSign("{")) warnOfEmptyBody(word)
        return Statement.For(first, condition, step, layout.body(word, statement), word.range)
    }

    private fun monitor(): Statement {
        val word = reader.advance()
        val events = expressions.inBrackets()
        val body = block()
        val handlers = mutableListOf<Handler>()
        while (accept(Keyword.CATCH)) {
            val handler = reader.previous
            val mask = if (reader.isSign("(")) expressions.constantOf(expressions.inBrackets()) else null
            handlers += Handler(mask, block(), handler.range)
        }
        return Statement.Monitor(events, body, handlers, word.range.to(events.range))
    }

    private fun acquire(): Statement {
        val word = reader.advance()
        val resources = expressions.inBrackets()
        val number = expressions.constantOf(resources)
        val body = block()
        val handler = if (accept(Keyword.CATCH)) block() else null
        return Statement.Acquire(number, body, handler, word.range.to(resources.range))
    }
}

package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.Expression
import robotran.nqc.tree.LeaveKind
import robotran.nqc.tree.Statement
import robotran.nqc.tree.Statement.Block

/** Reads statements. After a mistake it goes on with the next one. */
internal class StatementParser(
    private val reader: TokenReader,
    private val scopes: Scopes,
    private val names: NameResolver,
    private val expressions: ExpressionParser,
    private val variables: VariableParser,
    private val misspelled: MisspelledWords,
) {
    private val sink = reader.sink
    private val assignments = AssignmentParser(reader, expressions)
    private val tasks = TaskCommandParser(reader, names)
    private val flow = FlowParser(reader, expressions, assignments, misspelled, ::statement, ::block)

    /** Reads `{ statements }`, whose variables end with it. */
    fun block(): Statement {
        val brace = reader.token
        reader.opening("{")
        return scopes.inScope { Block(statements(brace), isScope = true, brace.range) }
    }

    /** Reads statements up to the `}` that belongs to [brace], and skips that. */
    fun statements(brace: Token): List<Statement> {
        val statements = mutableListOf<Statement>()
        while (!reader.accept("}")) {
            misspelled.correct()
            if (isNestedUnit()) {
                skipNestedUnit()
                continue
            }
            if (reader.token.kind == TokenKind.END || reader.token.keyword?.group == KeywordGroup.UNIT) {
                val message = sink.messages.missingBrace(brace.range.line)
                sink.report(NqcDiagnosticCode.MISSING_BRACE, reader.gap, message, reader.insertion("\n}"))
                break
            }
            val start = reader.index
            try {
                statements += statement()
            } catch (_: SyntaxFailure) {
                skipStatement(start)
            }
        }
        return statements
    }

    /** Whether a task, subroutine or function begins here, although nothing before it lacks its end. */
    private fun isNestedUnit(): Boolean {
        val keyword = reader.token.keyword
        val isFunction = keyword == Keyword.INT && reader.peek(2).isSign("(")
        return (keyword?.group == KeywordGroup.UNIT || isFunction) && reader.peek(1).kind == TokenKind.NAME &&
            reader.isBalanced
    }

    private fun skipNestedUnit() {
        val word = reader.advance()
        val name = reader.advance()
        sink.report(NqcDiagnosticCode.NESTED_UNIT, word.range.to(name.range), sink.messages.nestedUnit(name.text))
        while (reader.token.kind != TokenKind.END && !reader.isSign("{") && !reader.isSign("}")) reader.advance()
        if (reader.isSign("{")) skipRest()
    }

    /** Skips the rest of the statement that began at [start]. */
    private fun skipStatement(start: Int) {
        if (reader.index == start && !reader.isSign("}")) reader.advance()
        skipRest()
    }

    private fun skipRest() {
        var depth = 0
        while (reader.token.kind != TokenKind.END) {
            if (depth == 0 && (reader.isSign("}") || reader.token.keyword?.group == KeywordGroup.UNIT)) return
            val token = reader.advance()
            if (token.isSign("{")) depth++
            if (token.isSign("}") && --depth == 0) return
            if (depth == 0 && token.isSign(";")) return
        }
    }

    private fun statement(): Statement = reader.nested(NqcLimits.NESTED_STATEMENTS) {
        misspelled.correct()
        val token = reader.token
        when {
            reader.isSign("{") -> block()
            reader.accept(";") -> Block(emptyList(), isScope = false, token.range)
            token.kind == TokenKind.KEYWORD -> ofKeyword(token)
            token.kind == TokenKind.NAME && reader.peek(1).isSign(":") -> label()
            tasks.isCommand() -> tasks.command()
            token.kind == TokenKind.NAME && reader.peek(1).isSign("(") -> call()
            names.isCommandAlone() -> commandAlone()
            names.isBlockWord() -> blockAfterWord()
            names.isCallWithoutBrackets() -> callWithoutBrackets()
            else -> assignments.statement().also { reader.semicolon() }
        }
    }

    private fun ofKeyword(token: Token): Statement = when (val keyword = token.keyword) {
        Keyword.INT, Keyword.CONST -> declarations()
        Keyword.START, Keyword.STOP -> tasks.command(keyword)
        Keyword.BREAK -> leave(LeaveKind.BREAK)
        Keyword.CONTINUE -> leave(LeaveKind.CONTINUE)
        Keyword.RETURN -> leave(LeaveKind.RETURN)
        Keyword.GOTO -> goto()
        Keyword.ASM -> AssemblyParser(reader, expressions).assembly()
        Keyword.CASE, Keyword.DEFAULT -> case(keyword)
        Keyword.ELSE -> reader.fail(NqcDiagnosticCode.ELSE_ALONE, token.range, sink.messages.elseAlone())
        Keyword.CATCH -> reader.fail(NqcDiagnosticCode.CATCH_ALONE, token.range, sink.messages.catchAlone())
        null -> reader.unexpected()
        else -> flow.statement(keyword) ?: otherKeyword(keyword)
    }

    /** An expression that begins with [keyword], or a mistake. */
    private fun otherKeyword(keyword: Keyword): Statement {
        if (keyword.group == KeywordGroup.OTHER) reader.unexpected()
        return assignments.statement().also { reader.semicolon() }
    }

    /** Skips a name that is the whole statement and means no variable. */
    private fun commandAlone(): Statement {
        val name = reader.advance()
        names.reportCommandAlone(name)
        reader.semicolon()
        return Block(emptyList(), isScope = false, name.range)
    }

    /** Reads the block behind a name that means nothing. */
    private fun blockAfterWord(): Statement {
        names.reportCommandAlone(reader.advance())
        return block()
    }

    /** Skips a call whose arguments are in no brackets. */
    private fun callWithoutBrackets(): Statement {
        val name = reader.advance()
        val first = reader.token
        val last = reader.skipLine(name)
        names.reportCallWithoutBrackets(name, first.range.to(last.range))
        reader.semicolon()
        return Block(emptyList(), isScope = false, name.range)
    }

    private fun declarations(): Statement {
        val word = reader.token
        val declarations = variables.declarations()
        reader.semicolon()
        return declarations.singleOrNull() ?: Block(declarations, isScope = false, word.range)
    }

    private fun leave(kind: LeaveKind): Statement {
        val word = reader.advance()
        if (kind == LeaveKind.RETURN && startsValue()) {
            skipValue(word)
        }
        reader.semicolon()
        return Statement.Leave(kind, word.range)
    }

    /** Skips the value of a `return`. */
    private fun skipValue(word: Token) {
        val first = reader.token
        val last = reader.skipLine(word)
        val range = first.range.to(last.range)
        val fix = SourceFix(word.range.end.to(range), "").takeIf { word.macro == null && last.macro == null }
        sink.report(NqcDiagnosticCode.RETURN_WITH_VALUE, range, sink.messages.returnWithValue(), fix)
    }

    private fun startsValue(): Boolean {
        val isOnLine = reader.token.range.line == reader.previous.range.line
        val isValue = reader.token.kind == TokenKind.NUMBER || reader.token.kind == TokenKind.NAME ||
            reader.isSign("(") || reader.isSign("-")
        return isOnLine && isValue
    }

    private fun goto(): Statement {
        val word = reader.advance()
        val name = reader.name()
        reader.semicolon()
        return Statement.Goto(name.text, word.range.to(name.range))
    }

    private fun label(): Statement {
        val name = reader.advance()
        reader.advance()
        return Statement.Label(name.text, labelled(), name.range)
    }

    private fun case(keyword: Keyword): Statement {
        val word = reader.advance()
        val value = if (keyword == Keyword.CASE) expressions.expression() else null
        if (!reader.accept(":")) {
            val message = sink.messages.missingColon(word.text)
            reader.fail(NqcDiagnosticCode.MISSING_COLON, reader.gap, message, reader.insertion(":"))
        }
        val number = value?.let { expressions.constantOf(it) }
        if (value != null && number !in CASES) {
            sink.report(NqcDiagnosticCode.CASE_OUT_OF_RANGE, value.range, sink.messages.caseOutOfRange())
        }
        return Statement.Case(number, labelled(), word.range.to(value?.range ?: word.range))
    }

    /** The statement after a label. */
    private fun labelled(): Statement {
        if (reader.isSign("}")) {
            val message = sink.messages.statementAfterLabel()
            reader.fail(NqcDiagnosticCode.UNEXPECTED_TOKEN, reader.gap, message, reader.insertion(" ;"))
        }
        return statement()
    }

    private fun call(): Statement {
        val name = reader.advance()
        reader.advance()
        val arguments = mutableListOf<Expression>()
        if (!reader.isSign(")")) {
            do arguments += expressions.expression() while (reader.accept(","))
        }
        reader.closing(")")
        val end = reader.previous.range
        reader.semicolon()
        return Statement.Call(name.text, arguments, name.range, end, name.macro != null)
    }

    private companion object {
        val CASES = -32768..32767
    }
}

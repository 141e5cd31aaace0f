package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.config.ParameterLimit
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.FunctionUnit
import robotran.nqc.tree.ParsedProgram
import robotran.nqc.tree.Statement
import robotran.nqc.tree.SubUnit
import robotran.nqc.tree.TaskUnit

/**
 * Reads whole programs. Never throws.
 *
 * @param words the macros, for suggestions.
 * @param api the functions that exist from the beginning.
 * @param apiNames what messages say about them.
 * @param limitOf which constants make sense for the parameter of a function.
 * @param textAt what is typed somewhere in the program's files.
 */
internal class ProgramParser(
    tokens: List<Token>,
    private val sink: DiagnosticSink,
    private val target: FirmwareTarget,
    words: Set<String>,
    private val api: Map<String, FunctionUnit>,
    apiNames: ApiNames,
    private val limitOf: (function: String, parameter: String) -> ParameterLimit? = { _, _ -> null },
    textAt: (SourceRange) -> String? = { null },
) {
    /** The tasks, subroutines and functions of the whole program. */
    val declared = DeclaredUnits(tokens)

    private val units = HashSet<String>()
    private val reader = TokenReader(tokens, sink, textAt, isMacro = { it in words })
    private val scopes = Scopes(api.keys)
    private val names = NameResolver(
        reader,
        scopes,
        target,
        words,
        declared,
        api.keys,
        { it in units || it in api },
        apiNames,
    )
    private val misspelled =
        MisspelledWords(reader) { it in api || it in declared.names || scopes.variable(it) != null }
    private val expressions = ExpressionParser(reader, names)
    private val variables = VariableParser(reader, scopes, names, expressions)
    private val statements = StatementParser(reader, scopes, names, expressions, variables, misspelled)
    private val parameters = ParameterParser(reader, scopes, names)

    private val globals = mutableListOf<Statement.Declaration>()
    private val tasks = mutableListOf<TaskUnit>()
    private val subs = mutableListOf<SubUnit>()
    private val functions = LinkedHashMap<String, FunctionUnit>()

    /** @param isApi whether the functions belong to the API. */
    fun program(isApi: Boolean = false): ParsedProgram {
        while (reader.token.kind != TokenKind.END) {
            val start = reader.index
            try {
                unit(isApi)
            } catch (_: SyntaxFailure) {
                skipUnit(start)
            }
        }
        return ParsedProgram(globals, tasks, subs, api + functions)
    }

    private fun unit(isApi: Boolean) {
        misspelled.correct()
        val token = reader.token
        if (isMainFunction(token)) return mainTask()
        if (token.keyword == Keyword.INT && reader.peek(2).isSign("(")) reportType(token)
        when (reader.token.keyword) {
            Keyword.INT, Keyword.CONST -> {
                globals += variables.declarations()
                reader.semicolon()
            }

            Keyword.TASK -> task()
            Keyword.SUB -> sub()
            Keyword.VOID, Keyword.NO_LISTING -> function(isApi)

            Keyword.RESOURCE -> {
                reader.fail(NqcDiagnosticCode.RESOURCE_WRITTEN, token.range, sink.messages.resourceWritten())
            }

            else -> notAUnit(token)
        }
    }

    /** Whether here begins `int main()` or `void main()`, with which programs in C begin. */
    private fun isMainFunction(token: Token): Boolean = token.keyword in MAIN_FUNCTIONS &&
        reader.peek(1).let { it.kind == TokenKind.NAME && it.text == MAIN } && reader.peek(2).isSign("(")

    /** Reads the main task in spite of how it begins. */
    private fun mainTask() {
        val word = reader.advance()
        val name = unitName()
        reader.opening("(")
        while (reader.isInLineOf(word) && !reader.isSign(")") && !reader.isSign("{")) reader.advance()
        reader.closing(")")
        val range = word.range.to(reader.previous.range)
        val isTyped = word.macro == null && range.endColumn > word.range.endColumn
        val fix = SourceFix(range, MAIN_TASK).takeIf { isTyped }
        sink.report(NqcDiagnosticCode.FUNCTION_WITH_TYPE, word.range, sink.messages.mainFunction(MAIN_TASK), fix)
        tasks += TaskUnit(name.text, statements.block(), name.range)
    }

    /** Reports a function that begins with the type of its value, and reads it as one without. */
    private fun reportType(type: Token) {
        val name = reader.peek(1).takeIf { it.kind == TokenKind.NAME } ?: return
        val fix = SourceFix(type.range, Keyword.VOID.text).takeIf { type.macro == null }
        val message = sink.messages.functionWithType(name.text)
        sink.report(NqcDiagnosticCode.FUNCTION_WITH_TYPE, type.range, message, fix)
        reader.readAs(Keyword.VOID)
    }

    private fun notAUnit(token: Token): Nothing {
        if (token.text == INLINE && reader.peek(1).keyword == Keyword.VOID) {
            val fix = SourceFix(token.range, "").takeIf { token.macro == null }
            reader.fail(NqcDiagnosticCode.INLINE_WRITTEN, token.range, sink.messages.inlineWritten(), fix)
        }
        if (reader.isSign("}")) {
            val fix = SourceFix(token.range, "").takeIf { token.macro == null }
            reader.fail(NqcDiagnosticCode.MISSING_BRACE, token.range, sink.messages.extraBrace(), fix)
        }
        val isStatement = token.keyword?.group == KeywordGroup.STATEMENT || token.kind == TokenKind.NAME
        if (isStatement) {
            reader.fail(NqcDiagnosticCode.OUTSIDE_TASK, token.range, sink.messages.outsideTask(token.text))
        }
        reader.unexpected()
    }

    private fun task() {
        reader.advance()
        val name = unitName()
        reader.opening("(")
        scopes.inScope {
            if (!reader.isSign(")")) taskParameters(name)
            reader.closing(")")
            tasks += TaskUnit(name.text, statements.block(), name.range)
        }
    }

    /** Reads the parameters of the task [name], which cannot have any. */
    private fun taskParameters(name: Token) {
        val first = reader.token
        parameters.parameters()
        val range = first.range.to(reader.previous.range)
        val fix = SourceFix(range, "").takeIf { first.macro == null && reader.isInLineOf(first) }
        sink.report(NqcDiagnosticCode.UNEXPECTED_TOKEN, range, sink.messages.taskParameters(name.text), fix)
    }

    private fun sub() {
        reader.advance()
        val name = unitName()
        reader.opening("(")
        if (!reader.isSign(")")) {
            val range = reader.token.range
            sink.report(NqcDiagnosticCode.SUB_PARAMETERS, range, sink.messages.subParameters(target.word))
            scopes.inScope { parameters.parameters() }
        }
        reader.closing(")")
        subs += SubUnit(name.text, statements.block(), name.range)
    }

    private fun function(isApi: Boolean) {
        reader.accept(Keyword.NO_LISTING)
        if (!reader.accept(Keyword.VOID)) reader.unexpected()
        val name = unitName()
        reader.opening("(")
        scopes.inScope {
            val parameters = parameters.parameters()
            reader.closing(")")
            val limits = parameters.map { limitOf(name.text, it.name) }
            val function = FunctionUnit(name.text, parameters, name.range, isApi, limits)
            val brace = reader.token
            function.body = Statement.Block(emptyList(), isScope = false, brace.range)
            functions[name.text] = function
            reader.opening("{")
            function.body = Statement.Block(statements.statements(brace), isScope = false, brace.range)
        }
    }

    private fun unitName(): Token {
        val name = reader.name()
        val isFree = scopes.declareUnit(name.text, name.range)
        names.requireFreeName(isFree, name)
        units += name.text
        return name
    }

    /** Skips the rest of what began at [start] outside of tasks. */
    private fun skipUnit(start: Int) {
        if (reader.index == start) reader.advance()
        var depth = 0
        while (reader.token.kind != TokenKind.END) {
            if (depth == 0 && reader.token.keyword?.group in UNIT_GROUPS) return
            val token = reader.advance()
            if (token.isSign("{")) depth++
            if (token.isSign("}")) depth = maxOf(0, depth - 1)
        }
    }

    private companion object {
        const val INLINE = "inline"
        const val MAIN = "main"
        const val MAIN_TASK = "task main()"
        val MAIN_FUNCTIONS = setOf(Keyword.INT, Keyword.VOID, Keyword.SUB)
        val UNIT_GROUPS = setOf(KeywordGroup.UNIT, KeywordGroup.DECLARATION)
    }
}

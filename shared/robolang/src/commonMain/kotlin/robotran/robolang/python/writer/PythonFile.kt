package robotran.robolang.python.writer

import robotran.language.source.SourceRange
import robotran.robolang.RobolangProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.leadingDeclarations
import robotran.robolang.syntax.withParts
import robotran.robolang.translate.CommentsOfItems
import robotran.robolang.translate.JavaFlow
import robotran.robolang.translate.SourceLines

/** Assembles a translation: what the robot consists of, figures, functions, the main program. */
internal class PythonFile(
    program: RobolangProgram,
    targetOf: (PythonContext) -> PythonTarget,
    notes: PythonNotes,
    reserved: Set<String>,
) : PythonParts {
    private val checked = program.checked
    private val tree = checked.tree
    private val pythonNames = PythonNames(reserved)
    private val uses = PythonUses()
    private val context = PythonContext(checked, pythonNames, uses, notes)
    private val target = targetOf(context)
    private val expressions = PythonExpressions(checked, pythonNames, uses, target).also { context.expressions = it }
    private val comments = CommentsOfItems(tree)

    override val variables = SharedVariables(checked, target)

    override val closing: List<Token> get() = comments.closing

    /** The comments at the top of the program, also those right above its first line. */
    private val heading: List<Token> = comments.heading.ifEmpty {
        tree.comments.withIndex().takeWhile { (index, comment) -> comment.range.line == index + 1 }
            .map { it.value }.filter { isAlone(it) }
    }
    private val functions = PythonWriter(sourceLines = SourceLines(tree))

    /** The declarations that stand above the functions. */
    private val hoisted: List<Statement> = tree.leadingDeclarations.takeWhile { statement ->
        val declaration = statement as Statement.Declare
        if (target.hoistsDeclarations && (context.isReacting || tree.routines.isNotEmpty())) {
            withParts(declaration.value).none(::needsFunction)
        } else {
            declaration.isConstant && isFigure(declaration.value)
        }
    }

    override val statements: List<Statement> get() = tree.statements.drop(hoisted.size)

    /** The names that the translation itself uses. */
    val names: Set<String> get() = uses.names + target.names

    fun write(): PythonWriter {
        declareNames()
        target.tell(tree)
        val figures = PythonWriter(sourceLines = SourceLines(tree))
        if (hoisted.isNotEmpty()) write(hoisted, figures)
        tree.routines.forEach(::routine)
        val main = PythonWriter(sourceLines = SourceLines(tree))
        target.writeMain(this, functions, main)
        return whole(figures, main)
    }

    /** Whether nothing else is in the line of [comment]. */
    private fun isAlone(comment: Token): Boolean = comment.range.column == 1

    override fun commentsOf(range: SourceRange): List<Token> = comments.of(range).filter { it !in heading }

    private fun declareNames() {
        for (declaration in tree.statements.filterIsInstance<Statement.Declare>()) {
            val symbol = checked.symbolOf(declaration.name)
            pythonNames.declareShared(symbol, declaration.isConstant && isFigure(declaration.value))
        }
        tree.routines.forEach { pythonNames.declareShared(checked.symbolOf(it.name), isCapital = false) }
    }

    private fun isFigure(value: Expression): Boolean = when (value) {
        is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral -> true
        is Expression.ListOf -> value.elements.all { isFigure(it) }
        else -> false
    }

    /** Whether [part] needs a function, which is only defined further down. */
    private fun needsFunction(part: Expression): Boolean =
        (part is Expression.Call && checked.symbolOf(part.name).declaredAt != null) || target.needsFunction(part)

    override fun statements(writer: PythonWriter, place: PythonPlace): PythonStatements =
        PythonStatements(checked, pythonNames, expressions, target, context.notes, writer, place)

    override fun write(part: List<Statement>, writer: PythonWriter) = pythonNames.inScope {
        statements(writer, PythonPlace.Plain()).writeHere(part) { writer.takeComments(commentsOf(it.range)) }
        writer.commentsLeft()
    }

    private fun routine(routine: Routine) {
        val symbol = checked.symbolOf(routine.name)
        functions.gap()
        functions.takeComments(commentsOf(routine.range))
        target.routine(routine, symbol, this) { prefix, place -> routine(routine, symbol, prefix, place) }
    }

    private fun routine(routine: Routine, symbol: Symbol, prefix: String, place: PythonPlace) = pythonNames.inScope {
        val parameters = routine.parameters.map(checked::symbolOf)
        val list = parameters.joinToString { pythonNames.declareLocal(it) }
        val noted = (parameters + symbol).mapNotNull(pythonNames::noteOn).joinToString().ifEmpty { null }
        functions.open("${prefix}def ${pythonNames.of(symbol)}($list)", routine.range.line, noted)
        globals(routine.body, functions)
        statements(functions, place).write(routine.body)
        functions.commentsAbove(routine.endRange.line)
        if (routine.isFunction && JavaFlow(checked).completes(routine.body)) {
            functions.line("return ${defaultOf(symbol.type)}", routine.endRange.line)
        }
        functions.close(routine.endRange.line)
    }

    override fun globals(body: List<Statement>, writer: PythonWriter) {
        val names = variables.changedIn(body).map(pythonNames::of) + variables.ownChangedIn(body)
        writeGlobals(names.distinct(), writer)
    }

    private fun writeGlobals(names: List<String>, writer: PythonWriter) {
        if (names.isNotEmpty()) writer.line("global ${names.joinToString()}")
    }

    private fun defaultOf(type: ValueType): String = when (type) {
        ValueType.DECIMAL -> "0.0"
        ValueType.TRUTH -> "False"
        ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL -> "[]"
        ValueType.WHOLE, ValueType.COLOUR, ValueType.NOTHING -> "0"
    }

    private fun sharedInMain(): List<Symbol> = statements.filterIsInstance<Statement.Declare>()
        .map { checked.symbolOf(it.name) }.filter { it in variables.ofOthers }

    override fun globalsOfMain(writer: PythonWriter) {
        val changed = variables.changedIn(statements)
            .filter { symbol -> symbol in variables.ofOthers || isHoisted(symbol) }
        val names = (sharedInMain() + changed).map(pythonNames::of) + variables.ownChangedIn(statements)
        writeGlobals(names.distinct(), writer)
    }

    override fun declareShared(writer: PythonWriter) =
        sharedInMain().forEach { writer.line("${pythonNames.of(it)} = ${defaultOf(it.type)}") }

    private fun isHoisted(symbol: Symbol): Boolean =
        hoisted.any { checked.symbolOf((it as Statement.Declare).name) == symbol }

    private fun whole(figures: PythonWriter, main: PythonWriter): PythonWriter = PythonWriter().apply {
        val head = PythonWriter()
        tree.robot?.let { head.takeComments(commentsOf(it.range)) }
        tree.robot?.let { head.commentsAbove(it.range.line + 1) }
        target.writeHead(head)
        tree.robot?.let { head.commentsAbove(it.endRange.line + 1) }
        head.commentsLeft()
        takeComments(heading)
        commentsLeft()
        uses.writeImports(this)
        appendPart(head)
        appendPart(PythonWriter().apply(target::writeConstants))
        appendPart(figures)
        appendPart(PythonWriter().apply(target::writeState))
        uses.writeHelpers(this, target::textOf)
        if (!functions.isEmpty) {
            gap()
            append(functions)
        }
        if (functions.isEmpty && !uses.hasHelpers) blank() else gap()
        if (!main.isEmpty) append(main)
    }

    private fun PythonWriter.appendPart(part: PythonWriter) {
        if (!part.isEmpty) append(part)
    }
}

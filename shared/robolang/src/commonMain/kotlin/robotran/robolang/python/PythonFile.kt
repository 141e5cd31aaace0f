package robotran.robolang.python

import robotran.language.source.SourceRange
import robotran.robolang.RobolangProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.leadingDeclarations
import robotran.robolang.syntax.withParts
import robotran.robolang.translate.CommentsOfItems
import robotran.robolang.translate.JavaFlow
import robotran.robolang.translate.SourceLines

/** Assembles a translation: devices, figures, functions, the main program. */
internal class PythonFile(
    program: RobolangProgram,
    private val robot: RobotTarget.Hub,
    private val notes: PythonNotes,
    reserved: Set<String>,
) {
    private val checked = program.checked
    private val tree = checked.tree
    private val isReacting = tree.behaviours.isNotEmpty()
    private val hubUses = HubUses(tree, robot)
    private val speeds = PybricksSpeeds(tree, robot, hubUses)
    private val pythonNames = PythonNames(reserved)
    private val uses = PythonUses(robot, isReacting, speeds.ways)
    private val usesColours = allExpressions(tree).any {
        it is Expression.Sense && checked.typeOf(it) == ValueType.COLOUR
    }
    private val devices = PybricksDevices(robot, uses, usesColours)
    private val senses = PybricksSenses(robot, tree.robot, hubUses, devices, uses, notes)
    private val awaited = AwaitedRoutines(checked, senses::isAwaited)
    private val expressions = PythonExpressions(checked, pythonNames, uses, notes, awaited, senses::written)
    private val commands = PybricksCommands(robot, expressions, devices, uses, notes, speeds)
    private val variables = SharedVariables(checked, speeds)
    private val comments = CommentsOfItems(tree)

    /** The comments at the top of the program, also those right above its first line. */
    private val heading: List<Token> = comments.heading.ifEmpty {
        tree.comments.withIndex().takeWhile { (index, comment) -> comment.range.line == index + 1 }
            .map { it.value }.filter { isAlone(it) }
    }
    private val functions = PythonWriter(sourceLines = SourceLines(tree))

    /** The declarations that stand above the functions. */
    private val hoisted: List<Statement> = tree.leadingDeclarations.takeWhile { statement ->
        val declaration = statement as Statement.Declare
        if (isReacting || tree.routines.isNotEmpty()) {
            withParts(declaration.value).none(::needsFunction)
        } else {
            declaration.isConstant && isFigure(declaration.value)
        }
    }

    /** The names that the translation itself uses. */
    val names: Set<String>
        get() = uses.names + devices.names + commands.names + (if (isReacting) setOf("main") else emptySet())

    fun write(): PythonWriter {
        senses.expressions = expressions
        declareNames()
        NotesOnLoops(notes, expressions).tell(tree)
        val figures = PythonWriter(sourceLines = SourceLines(tree))
        if (hoisted.isNotEmpty()) write(hoisted, figures)
        tree.routines.forEach(::routine)
        val main = PythonWriter(sourceLines = SourceLines(tree))
        if (isReacting) tasks(main) else mainProgram(main)
        return whole(figures, main)
    }

    /** Whether nothing else is in the line of [comment]. */
    private fun isAlone(comment: Token): Boolean = comment.range.column == 1

    private fun commentsOf(range: SourceRange): List<Token> = comments.of(range).filter { it !in heading }

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

    /** Whether [part] needs a function of the program, which is only defined further down. */
    private fun needsFunction(part: Expression): Boolean = when (part) {
        is Expression.Call -> checked.symbolOf(part.name).declaredAt != null || part.name.key == BuiltIn.RANDOM.text

        is Expression.Binary -> {
            val isDivision = part.operator == BinaryOperator.DIVIDE || part.operator == BinaryOperator.MOD
            isDivision && !(expressions.isNeverBelow(part.left) && expressions.isNeverBelow(part.right))
        }

        is Expression.Sense -> part.sense == Sense.Distance || part.sense is Sense.Sensor
        else -> false
    }

    private fun statements(writer: PythonWriter, place: PythonPlace): PythonStatements = PythonStatements(
        checked,
        pythonNames,
        expressions,
        commands,
        devices,
        notes,
        uses,
        writer,
    ).also { it.place = place }

    /** Statements of the main program outside of tasks. */
    private fun write(part: List<Statement>, writer: PythonWriter) = pythonNames.inScope {
        statements(writer, PythonPlace.Plain).writeHere(part) { writer.takeComments(commentsOf(it.range)) }
        writer.commentsLeft()
    }

    private fun routine(routine: Routine) {
        val symbol = checked.symbolOf(routine.name)
        val isAsync = symbol in awaited
        functions.gap()
        functions.takeComments(commentsOf(routine.range))
        expressions.isInTask = isAsync
        pythonNames.inScope {
            val parameters = routine.parameters.map(checked::symbolOf)
            val list = parameters.joinToString { pythonNames.declareLocal(it) }
            val noted = (parameters + symbol).mapNotNull(pythonNames::noteOn).joinToString().ifEmpty { null }
            val head = (if (isAsync) "async " else "") + "def ${pythonNames.of(symbol)}($list)"
            functions.open(head, routine.range.line, noted)
            globals(variables.changedBy(routine.body), functions)
            val isOfMain = isAsync && routine !in variables.ofBehaviours
            val place = PythonPlace.Routine(symbol.type.takeIf { routine.isFunction }, uses.takeIf { isOfMain })
            statements(functions, place).write(routine.body)
            functions.commentsAbove(routine.endRange.line)
            if (routine.isFunction && JavaFlow(checked).completes(routine.body)) {
                functions.line("return ${defaultOf(symbol.type)}", routine.endRange.line)
            }
            functions.close(routine.endRange.line)
        }
        expressions.isInTask = false
    }

    private fun globals(names: List<String>, writer: PythonWriter) {
        if (names.isNotEmpty()) writer.line("global ${names.joinToString()}")
    }

    private fun SharedVariables.changedBy(body: List<Statement>): List<String> =
        (changedIn(body).map(pythonNames::of) + speedsChangedIn(body)).distinct()

    private fun defaultOf(type: ValueType): String = when (type) {
        ValueType.DECIMAL -> "0.0"
        ValueType.TRUTH -> "False"
        ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL -> "[]"
        ValueType.WHOLE, ValueType.COLOUR, ValueType.NOTHING -> "0"
    }

    private fun mainProgram(main: PythonWriter) {
        write(tree.statements.drop(hoisted.size), main)
        main.takeComments(comments.closing)
        main.commentsLeft()
        if (!JavaFlow(checked).completes(tree.statements)) return
        EndOfProgram(tree.statements, speeds.mayTurnAtEnd, robot.pen != null, commands).write(main)
    }

    private fun tasks(main: PythonWriter) {
        notes.tell(tree.behaviours.first().range, notes.messages.tasks())
        val tasks =
            PythonTasks(checked, pythonNames, expressions, uses, ::commentsOf, comments.closing) { writer, place ->
                statements(writer, place)
            }
        tasks.writeBehaviours(functions) { globals(variables.changedBy(it), functions) }
        val rest = tree.statements.drop(hoisted.size)
        functions.gap()
        functions.open("async def main()")
        val shared = rest.filterIsInstance<Statement.Declare>().map { checked.symbolOf(it.name) }
            .filter { it in variables.ofOthers }
        val changed = variables.changedIn(rest).filter { symbol -> symbol in variables.ofOthers || isHoisted(symbol) }
        globals(((shared + changed).map(pythonNames::of) + variables.speedsChangedIn(rest)).distinct(), functions)
        tasks.writeMain(functions, rest, JavaFlow(checked).completes(rest) && rest.lastOrNull() !is Statement.Halt)
        functions.close()
        shared.forEach { main.line("${pythonNames.of(it)} = ${defaultOf(it.type)}") }
        tasks.writeStart(main)
    }

    private fun isHoisted(symbol: Symbol): Boolean =
        hoisted.any { checked.symbolOf((it as Statement.Declare).name) == symbol }

    private fun whole(figures: PythonWriter, main: PythonWriter): PythonWriter = PythonWriter().apply {
        val head = PythonWriter()
        tree.robot?.let { head.takeComments(commentsOf(it.range)) }
        tree.robot?.let { head.commentsAbove(it.range.line + 1) }
        devices.write(head)
        tree.robot?.let { head.commentsAbove(it.endRange.line + 1) }
        head.commentsLeft()
        takeComments(heading)
        commentsLeft()
        uses.writeImports(this)
        appendPart(head)
        appendPart(PythonWriter().apply { commands.constants.forEach { line(it) } })
        appendPart(figures)
        if (isReacting) appendPart(PythonWriter().apply { lines(ACTING) })
        uses.writeHelpers(this)
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

    private companion object {
        const val ACTING =
            "# The number of the behaviour that acts: 0 is the main program, a higher number goes first.\nacting = 0"
    }
}

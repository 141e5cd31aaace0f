package robotran.robolang.python.pybricks

import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonHelper
import robotran.robolang.python.writer.PythonParts
import robotran.robolang.python.writer.PythonPlace
import robotran.robolang.python.writer.PythonTarget
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.python.writer.primary
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions
import robotran.robolang.translate.JavaFlow

/** Python for a hub with Pybricks: objects for its parts, and tasks for what goes on beside the main program. */
internal class PybricksTarget(private val robot: RobotTarget.Hub, private val context: PythonContext) : PythonTarget {
    private val tree = context.tree
    private val uses = context.uses
    private val hubUses = HubUses(tree, robot)
    private val speeds = PybricksSpeeds(tree, robot, hubUses)
    private val awaiting = PybricksAwaiting()
    private val usesColours = allExpressions(tree).any {
        it is Expression.Sense && context.program.typeOf(it) == ValueType.COLOUR
    }
    private val devices = PybricksDevices(robot, uses, usesColours)
    private val senses =
        PybricksSenses(robot, tree.robot, hubUses, devices, context).also { it.awaiting = awaiting }
    private val awaited = AwaitedRoutines(context.program, senses::isAwaited)
    private val commands = PybricksCommands(robot, context, awaiting, devices, speeds)

    override val arithmetic = PybricksArithmetic(context)

    override val mathsModule: String get() = "umath"

    override val hoistsDeclarations: Boolean get() = true

    override val names: Set<String>
        get() = devices.names + commands.names + (if (context.isReacting) setOf("main") else emptySet())

    override fun textOf(helper: PythonHelper): String =
        (helper as PybricksHelper).textFor(robot, context.isReacting, speeds.directions)

    override fun linesOf(command: Command): List<String> = commands.linesOf(command)

    override fun takesTime(command: Command): Boolean =
        command.waits || command is Command.Beep || command is Command.Buzz || command is Command.ShowText

    override fun pause(): String = commands.wait("${PybricksCommands.PAUSE}")

    override fun halt(place: PythonPlace): List<String> {
        val stop = if (commands.mayTurnAtEnd) commands.stop() else emptyList()
        return stop + if (place is MainTaskPlace) "return" else "raise SystemExit"
    }

    override fun reading(expression: Expression.Sense): PythonText = senses.written(expression.sense, expression)

    override fun colour(expression: Expression.ColourLiteral): PythonText =
        primary(uses.parameter("Color.${expression.colour.name}"))

    override fun called(routine: Symbol, call: String): PythonText =
        awaiting.waiting(call, awaiting.isInTask && routine in awaited)

    override fun needsFunction(expression: Expression): Boolean = when (expression) {
        is Expression.Call -> expression.name.key == BuiltIn.RANDOM.text
        is Expression.Binary -> arithmetic.needsHelper(expression)
        is Expression.Sense -> expression.sense == Sense.Distance || expression.sense is Sense.Sensor
        else -> false
    }

    override fun variablesChangedBy(statement: Statement): List<String> = speeds.changedBy(statement)

    override fun tell(tree: SyntaxTree) = NotesOnLoops(context.notes, context.expressions).tell(tree)

    override fun checkpoint(): () -> Unit {
        val used = uses.copy()
        val made = devices.copy()
        return {
            uses.takeBack(used)
            devices.takeBack(made)
        }
    }

    override fun routine(
        routine: Routine,
        symbol: Symbol,
        parts: PythonParts,
        write: (prefix: String, PythonPlace) -> Unit,
    ) {
        val isAsync = symbol in awaited
        val isOfMain = isAsync && routine !in parts.variables.ofBehaviours
        val place = RoutinePlace(symbol.type.takeIf { routine.isFunction }, uses.takeIf { isOfMain })
        awaiting.isInTask = isAsync
        write(if (isAsync) "async " else "", place)
        awaiting.isInTask = false
    }

    override fun writeHead(writer: PythonWriter) = devices.write(writer)

    override fun writeConstants(writer: PythonWriter) = commands.constants.forEach { writer.line(it) }

    override fun writeState(writer: PythonWriter) {
        if (context.isReacting) writer.lines(ACTING)
    }

    override fun writeMain(parts: PythonParts, functions: PythonWriter, main: PythonWriter) {
        if (context.isReacting) return tasks(parts, functions, main)
        parts.write(parts.statements, main)
        main.takeComments(parts.closing)
        main.commentsLeft()
        if (!JavaFlow(context.program).completes(tree.statements)) return
        EndOfProgram(tree.statements, speeds.mayTurnAtEnd, robot.pen != null, commands).write(main)
    }

    private fun tasks(parts: PythonParts, functions: PythonWriter, main: PythonWriter) {
        context.notes.tell(tree.behaviours.first().range, context.notes.messages.tasks())
        val tasks = PybricksTasks(context, awaiting, parts)
        tasks.writeBehaviours(functions)
        val rest = parts.statements
        functions.gap()
        functions.open("async def main()")
        parts.globalsOfMain(functions)
        val isEndReached = JavaFlow(context.program).completes(rest) && rest.lastOrNull() !is Statement.Halt
        tasks.writeMain(functions, rest, isEndReached)
        functions.close()
        parts.declareShared(main)
        tasks.writeStart(main)
    }

    private companion object {
        const val ACTING =
            "# The number of the behaviour that acts: 0 is the main program, a higher number goes first.\nacting = 0"
    }
}

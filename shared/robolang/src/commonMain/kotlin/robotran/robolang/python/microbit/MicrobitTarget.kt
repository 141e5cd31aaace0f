package robotran.robolang.python.microbit

import robotran.robolang.check.Symbol
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonHelper
import robotran.robolang.python.writer.PythonParts
import robotran.robolang.python.writer.PythonPlace
import robotran.robolang.python.writer.PythonTarget
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree

/**
 * Python for a micro:bit on a buggy: the numbers of this robot, functions for what it does, and a main program that stops
 * the wheels whatever happens.
 */
internal class MicrobitTarget(private val robot: RobotTarget.Microbit, private val context: PythonContext) :
    PythonTarget {
    private val tree = context.tree
    private val uses = context.uses
    private val state = MicrobitState(tree, robot)
    private val wheels = MicrobitWheels(uses)
    private val readings = MicrobitReadings(robot, context, state, wheels)
    private val watched = WatchedVariables(context)
    private val helpers = MicrobitHelperTexts(robot, context, state, wheels, watched)
    private val figures = MicrobitFigureLines(robot, state, uses)

    override val arithmetic = MicrobitArithmetic(context)
    private val commands = MicrobitCommands(robot, context, state) { arithmetic.ranges }

    override val mathsModule: String get() = "math"

    override val hoistsDeclarations: Boolean get() = false

    override val names: Set<String> get() = state.names + readings.names + OWN

    override fun textOf(helper: PythonHelper): String = helpers.textOf(helper as MicrobitHelper)

    override fun linesOf(command: Command): List<String> = commands.linesOf(command)

    override fun takesTime(command: Command): Boolean = command.waits

    override fun pause(): String = commands.pause()

    override fun look(): String? = if (context.isReacting) "${uses.use(MicrobitHelper.LOOK)}()" else null

    override fun linesBehind(statement: Statement): List<String> =
        if (watched.changes(statement)) listOfNotNull(look()) else emptyList()

    override fun halt(place: PythonPlace): List<String> = listOf("raise SystemExit")

    override fun reading(expression: Expression.Sense): PythonText = readings.read(expression)

    override fun colour(expression: Expression.ColourLiteral): PythonText =
        error("The checker lets no colours get to a board.")

    override fun needsFunction(expression: Expression): Boolean = true

    override fun variablesChangedBy(statement: Statement): List<String> = state.changedBy(statement)

    override fun tell(tree: SyntaxTree) = DeepCallNotes(robot, context).tell()

    override fun checkpoint(): () -> Unit {
        val used = uses.copy()
        val takeBackState = state.checkpoint()
        val takeBackReadings = readings.checkpoint()
        return {
            uses.takeBack(used)
            takeBackState()
            takeBackReadings()
        }
    }

    override fun routine(
        routine: Routine,
        symbol: Symbol,
        parts: PythonParts,
        write: (prefix: String, PythonPlace) -> Unit,
    ) = write("", PythonPlace.Plain(symbol.type.takeIf { routine.isFunction }))

    override fun writeHead(writer: PythonWriter) = figures.writeTo(writer)

    override fun writeConstants(writer: PythonWriter) = Unit

    override fun writeState(writer: PythonWriter) {
        if (MicrobitHelper.DISTANCE in uses) {
            writer.line("heard_at = -60")
            writer.line("heard = 255")
        }
        if (state.remembersWheels) writer.line("left_way = right_way = 0", note = "1 ahead, -1 back, 0 stands.")
        if (state.drives && context.isReacting) writer.line("driving = False")
        if (context.isReacting) {
            val first = if (watched.isCalledEarly) tree.behaviours.size else 0
            writer.line("acting = $first", note = "The number of the behaviour that acts, 0 is the main program.")
        }
        for (function in readings.functions()) {
            writer.gap()
            writer.lines(function.joinToString("\n"))
        }
    }

    override fun writeMain(parts: PythonParts, functions: PythonWriter, main: PythonWriter) {
        val start = uses.use(MicrobitHelper.START)
        val reactions = if (context.isReacting) MicrobitReactions(context, parts, watched) else null
        reactions?.writeBehaviours(functions)
        reactions?.writeList(main)
        main.line("$start()")
        main.open("try")
        if (state.usesTimerIn(tree)) {
            main.line("${state.timer()} = ${uses.import("microbit", "running_time")}()")
        }
        if (reactions == null) parts.write(parts.statements, main) else reactions.writeMain(main)
        main.takeComments(parts.closing)
        main.commentsLeft()
        main.close()
        main.open("finally")
        main.line("${uses.use(MicrobitHelper.STOP)}()")
        main.close()
        helpers.useImports()
        readings.functions()
    }

    private companion object {
        /** Python's own words that it needs besides. */
        val OWN = setOf("Exception", "OSError", "bytes", "pow", "behaviours")
    }
}

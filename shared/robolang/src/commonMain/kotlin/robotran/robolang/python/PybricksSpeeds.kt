package robotran.robolang.python

import robotran.brick.controls.MotorPort
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements

/**
 * How a program keeps the speeds that its powers set: as constants if it sets none; as variables of the driving base if it
 * sets both wheels alike; as variables of each motor otherwise.
 */
internal class PybricksSpeeds(private val tree: SyntaxTree, private val robot: PybricksRobot) {
    private val commands = allStatements(tree).filterIsInstance<Command>()
    private val motorsWithPower = commands.filterIsInstance<Command.Motor>()
        .filter { it.command is MotorCommand.Power }.map { portOf(it.port) }.toSet()

    /** Whether the program sets a power of both wheels, or of one. */
    private val setsPower = commands.any { it is Command.Power }

    /** Whether it drives until it stops, so that the speed has to be known. */
    private val startsDriving = commands.any { startsDriving(it) }

    /** Whether each wheel has a speed of its own. */
    val areApart: Boolean = commands.any { it is Command.Power && it.side != PowerSide.BOTH } ||
        motorsWithPower.any { it in wheels } ||
        (setsPower && commands.any { it is Command.Motor && portOf(it.port) in wheels && isRun(it) })

    /** Whether the program sets the power of both wheels and needs the speed itself afterwards. */
    val areVariables: Boolean = setsPower && startsDriving && !areApart

    /** Whether it drives with both wheels at once. */
    val useBase: Boolean = commands.any {
        it is Command.Move || it is Command.Turn || it is Command.StartMoving || it is Command.StartTurning ||
            it is Command.StopDriving
    }

    /** Whether it drives by a distance or turns by an angle. */
    val useMoves: Boolean = commands.any {
        (it is Command.Move && it.distance != null) || (it is Command.Turn && it.angle != null)
    }

    /** Whether its wheels may turn when it ends. */
    val mayTurnAtEnd: Boolean = commands.any {
        it is Command.StartMoving || it is Command.StartTurning || (it is Command.Motor && portOf(it.port) in wheels)
    }

    private val wheels: List<Char> get() = listOf(robot.left.port, robot.right.port)

    private fun isRun(command: Command.Motor): Boolean =
        command.command == MotorCommand.Forward || command.command == MotorCommand.Backward

    private fun startsDriving(command: Command): Boolean = when (command) {
        is Command.StartMoving, is Command.StartTurning -> true
        is Command.Move -> command.distance == null
        is Command.Turn -> command.angle == null
        else -> false
    }

    /** The variable with the speed of the motor on [port]; null if that never changes. */
    fun variableOf(port: Char): String? = when {
        areApart && port == robot.left.port -> LEFT
        areApart && port == robot.right.port -> RIGHT
        port in motorsWithPower -> "speed_${port.lowercaseChar()}"
        else -> null
    }

    /** All such variables. */
    val variables: List<String>
        get() = (wheels.filter { areApart } + motorsWithPower).distinct().mapNotNull { variableOf(it) }

    /** Those that the main program sets before it does anything else. */
    val setFirst: Set<String>
        get() = if (tree.behaviours.isNotEmpty()) {
            emptySet()
        } else {
            tree.statements.takeWhile { changedBy(it).isNotEmpty() || isFigure(it) }.flatMap { changedBy(it) }.toSet()
        }

    private fun isFigure(statement: Statement): Boolean =
        statement is Statement.Declare && statement.value is Expression.Number

    /** Those that [statement] itself changes. */
    fun changedBy(statement: Statement): List<String> = when {
        statement is Command.Power && areApart -> when (statement.side) {
            PowerSide.BOTH -> listOf(LEFT, RIGHT)
            PowerSide.LEFT -> listOf(LEFT)
            PowerSide.RIGHT -> listOf(RIGHT)
        }

        statement is Command.Motor && statement.command is MotorCommand.Power -> {
            listOfNotNull(variableOf(portOf(statement.port)))
        }

        else -> emptyList()
    }

    private fun portOf(port: MotorPort): Char = port.name.single()

    companion object {
        const val LEFT = "left_speed"
        const val RIGHT = "right_speed"
    }
}

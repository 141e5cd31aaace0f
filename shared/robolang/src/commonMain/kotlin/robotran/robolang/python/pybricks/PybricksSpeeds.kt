package robotran.robolang.python.pybricks

import robotran.brick.controls.MotorPort
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
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
internal class PybricksSpeeds(private val tree: SyntaxTree, private val robot: RobotTarget.Hub, uses: HubUses) {
    private val commands = allStatements(tree).filterIsInstance<Command>()
    private val motorsWithPower = commands.filterIsInstance<Command.Motor>()
        .filter { it.command is MotorCommand.Power }.map { it.port }.toSet()

    /** Whether the program sets a power of both wheels, or of one. */
    private val setsPower = commands.any { it is Command.Power }

    /** Whether each wheel has a speed of its own. */
    val areApart: Boolean = uses.areWheelsApart

    /** Whether the program sets the power of both wheels and needs the speed itself afterwards. */
    val areVariables: Boolean = setsPower && !areApart && commands.any { isDrivenByTime(it) }

    /** Whether it drives with both wheels at once. */
    val useBase: Boolean = uses.baseLine != null

    /** Whether it drives by a distance or turns by an angle. */
    val useMoves: Boolean = commands.any {
        (it is Command.Move && it.distance != null) || (it is Command.Turn && it.angle != null)
    }

    /** Whether its wheels may turn when it ends. */
    val mayTurnAtEnd: Boolean = commands.any {
        it is Command.StartMoving || it is Command.StartTurning || (it is Command.Motor && it.port in wheels)
    }

    /** What new powers do while the wheels or a motor turn. */
    val directions = PybricksDirections(tree, robot)

    private val wheels: List<MotorPort> get() = listOf(robot.left, robot.right)

    private fun isDrivenByTime(command: Command): Boolean = when (command) {
        is Command.StartMoving, is Command.StartTurning -> true
        is Command.Move -> command.distance == null
        is Command.Turn -> command.angle == null
        else -> false
    }

    /** The variable with the speed of [motor]; null if that never changes. */
    fun variableOf(motor: MotorPort): String? = when {
        areApart && motor == robot.left -> LEFT
        areApart && motor == robot.right -> RIGHT
        motor in motorsWithPower -> "speed_${letterOf(motor)}"
        else -> null
    }

    /** All such variables. */
    val variables: List<String>
        get() = (wheels.filter { areApart } + motorsWithPower).distinct().mapNotNull { variableOf(it) }

    /** Those that hold which way something turns. */
    val directionVariables: List<String>
        get() = when {
            areVariables -> directions.variablesOfBase
            else -> (wheels.filter { areApart } + motorsWithPower).distinct().mapNotNull { directions.variableOf(it) }
        }

    /** What the main program sets before it does anything else. */
    private val first: List<Statement>
        get() = if (tree.behaviours.isNotEmpty()) {
            emptyList()
        } else {
            tree.statements.takeWhile { powersOf(it).isNotEmpty() || isFigure(it) }
        }

    /** The variables that the main program sets before it does anything else. */
    val setFirst: Set<String> get() = first.flatMap { powersOf(it) }.toSet()

    /** Whether nothing turns yet at [statement]. */
    fun isFirst(statement: Statement): Boolean = statement in first

    private fun isFigure(statement: Statement): Boolean =
        statement is Statement.Declare && statement.value is Expression.Number

    /** The variables that [statement] itself changes. */
    fun changedBy(statement: Statement): List<String> = powersOf(statement) + directionsOf(statement)

    private fun powersOf(statement: Statement): List<String> = when {
        statement is Command.Power && areApart -> when (statement.side) {
            PowerSide.BOTH -> listOf(LEFT, RIGHT)
            PowerSide.LEFT -> listOf(LEFT)
            PowerSide.RIGHT -> listOf(RIGHT)
        }

        statement is Command.Motor && statement.command is MotorCommand.Power -> {
            listOfNotNull(variableOf(statement.port))
        }

        else -> emptyList()
    }

    private fun directionsOf(statement: Statement): List<String> {
        if (directionVariables.isEmpty() || statement !is Command) return emptyList()
        return when {
            directions.drives(statement) && areVariables -> directions.variablesOfBase
            directions.drives(statement) -> wheels.mapNotNull { directions.variableOf(it) }

            statement is Command.Motor && directions.isRun(statement) ->
                listOfNotNull(directions.variableOf(statement.port))

            statement is Command.MotorTurn -> listOfNotNull(directions.variableOf(statement.port))
            else -> emptyList()
        }.filter { it in directionVariables }
    }

    companion object {
        const val LEFT = "left_speed"
        const val RIGHT = "right_speed"
    }
}

/** The letter of [motor] in a name of Python. */
internal fun letterOf(motor: MotorPort): Char = motor.name.single().lowercaseChar()

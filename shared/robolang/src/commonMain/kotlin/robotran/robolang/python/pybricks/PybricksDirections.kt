package robotran.robolang.python.pybricks

import robotran.brick.controls.MotorPort
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.TurnDirection
import robotran.robolang.syntax.allStatements

/**
 * The direction in which something turns while its power changes: then it is told again, with the new speed. A hub does not know what it
 * was told last, so a program that says more than one thing keeps it in variables: 1, -1, or 0 for what ends by itself.
 */
internal class PybricksDirections(tree: SyntaxTree, private val robot: RobotTarget.Hub) {
    private val commands = allStatements(tree).filterIsInstance<Command>()
    private val isReacting = tree.behaviours.isNotEmpty()

    /** The directions that both wheels are told: ahead, and to the right. */
    private val ofBase: Set<Pair<Int, Int>> = commands.filter(::drives).map(::directionOf).toSet()

    /** Whether [command] lets the wheels turn, or another command may come while it does. */
    fun drives(command: Command): Boolean = when (command) {
        is Command.StartMoving, is Command.StartTurning -> true
        is Command.Move, is Command.Turn -> isReacting
        else -> false
    }

    fun isRun(command: Command.Motor): Boolean =
        command.command == MotorCommand.Forward || command.command == MotorCommand.Backward

    /** Whether the wheels may turn when the power of both changes. */
    val driveOn: Boolean get() = ofBase.any { it != NONE }

    /** The only direction that both wheels are told; null if there are several. */
    val onlyOfBase: Pair<Int, Int>? get() = ofBase.singleOrNull()

    /** The variables with the direction of both wheels; empty if there is only one. */
    val variablesOfBase: List<String> get() = if (driveOn && onlyOfBase == null) listOf(AHEAD, TURN) else emptyList()

    /** What a program that drives ahead by [ahead] or to the right by [turn] does first. */
    fun remember(ahead: Int, turn: Int): List<String> =
        if (variablesOfBase.isEmpty()) emptyList() else listOf("$AHEAD, $TURN = $ahead, $turn")

    /** The directions that [motor] is told. */
    private fun directionsOf(motor: MotorPort): Set<Int> {
        val ofWheel = ofBase.map { (ahead, turn) -> ahead + if (motor == robot.left) turn else -turn }
            .takeIf { motor == robot.left || motor == robot.right }.orEmpty()
        val own = commands.mapNotNull { command ->
            when {
                command is Command.Motor && command.port == motor && isRun(command) -> signOf(command)
                command is Command.MotorTurn && command.port == motor -> 0
                else -> null
            }
        }
        return (ofWheel + own).toSet()
    }

    private fun signOf(command: Command.Motor): Int = if (command.command == MotorCommand.Forward) 1 else -1

    /** Whether [motor] may turn when its power changes. */
    fun runsOn(motor: MotorPort): Boolean = directionsOf(motor).any { it != 0 }

    /** The only direction that [motor] is told; null if there are several. */
    fun onlyOf(motor: MotorPort): Int? = directionsOf(motor).singleOrNull()

    /** The variable with the direction of [motor]; null if there is only one. */
    fun variableOf(motor: MotorPort): String? = when {
        !runsOn(motor) || onlyOf(motor) != null -> null
        motor == robot.left -> "left_way"
        motor == robot.right -> "right_way"
        else -> "way_${letterOf(motor)}"
    }

    private fun directionOf(command: Command): Pair<Int, Int> = when (command) {
        is Command.StartMoving -> signOf(command.direction) to 0
        is Command.StartTurning -> 0 to signOf(command.direction)
        is Command.Move -> if (command.distance == null) signOf(command.direction) to 0 else NONE
        is Command.Turn -> if (command.angle == null) 0 to signOf(command.direction) else NONE
        else -> NONE
    }

    companion object {
        const val AHEAD = "ahead"
        const val TURN = "turn"
        private val NONE = 0 to 0
    }
}

internal fun signOf(direction: MoveDirection): Int = if (direction == MoveDirection.FORWARD) 1 else -1

/** A turn to the right is positive. */
internal fun signOf(direction: TurnDirection): Int = if (direction == TurnDirection.RIGHT) 1 else -1

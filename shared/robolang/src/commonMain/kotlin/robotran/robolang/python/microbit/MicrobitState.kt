package robotran.robolang.python.microbit

import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.allStatements

/** What a translation needs of figures and variables besides its functions. */
internal class MicrobitState(tree: SyntaxTree, robot: RobotTarget.Microbit) {
    /** What keeps the sound of a board with a loudspeaker off pin 0, where a buggy without a buzzer may have a motor. */
    val pin: String = if (robot.model.hasSpeaker && robot.buggy.buzzer == null) "pin=None, " else ""

    private val commands = allStatements(tree).filterIsInstance<Command>()

    /** Whether the program changes powers, or turns one wheel alone: then each wheel's way and power is remembered. */
    val remembersWheels: Boolean = commands.any { it is Command.Power || it is Command.Motor }

    private val setsPower: Boolean =
        commands.any { it is Command.Power || (it as? Command.Motor)?.command is MotorCommand.Power }

    /** Whether powers are looked up in a table. */
    val hasTable: Boolean get() = setsPower

    /** Whether a way may be below 0, so that the robot goes the other way. */
    var goesBack = false

    var makesSounds = false

    /** Whether it drives by a time, which a behaviour cuts short. */
    var drives = false
        private set

    private var used = setOf<String>()

    fun go() {
        drives = true
    }

    fun timer(): String = use(TIMER)

    fun penDown(): String = use(PEN_DOWN)

    fun penUp(): String = use(PEN_UP)

    private fun use(name: String): String = name.also { used = used + it }

    /** Whether [tree] asks for the time since its start. */
    fun usesTimerIn(tree: SyntaxTree): Boolean =
        TIMER in used || allExpressions(tree).any { (it as? Expression.Sense)?.sense == Sense.Timer }

    /** The angles of the pen that are used. */
    val angles: Set<String> get() = used - TIMER

    val names: Set<String>
        get() = used + setOf("LEFT", "RIGHT") +
            (if (remembersWheels) setOf("left_way", "right_way", "left_power", "right_power", "POWERS") else emptySet())

    /** The variables that [statement] itself changes; powers and ways change in functions. */
    fun changedBy(statement: Statement): List<String> =
        if (statement is Command.ResetTimer) listOf(TIMER) else emptyList()

    /** Keeps what is used so far; what comes back takes back all that is used since. */
    fun checkpoint(): () -> Unit {
        val before = used
        val back = goesBack
        val sounds = makesSounds
        val drove = drives
        return {
            used = before
            goesBack = back
            makesSounds = sounds
            drives = drove
        }
    }

    companion object {
        const val TIMER = "timer_start"
        const val PEN_DOWN = "PEN_DOWN"
        const val PEN_UP = "PEN_UP"
    }
}

package robotran.robolang.run

import robotran.robolang.messages.RobolangRunMessages
import robotran.robolang.robot.Durations

/**
 * The state shared by all activities of a run: the robot, the main program's variables, lists, random numbers and the
 * timer.
 */
internal class InterpreterState(
    val code: Code,
    val robot: RobotDevice,
    val durations: Durations,
    val messages: RobolangRunMessages,
) {
    val timer = ProgramTimer(robot)

    /** The activities that have values, set by the run. */
    var activities: () -> List<Activity> = { emptyList() }

    val lists = Lists(messages, if (robot.collectsLists) ::eachValue else null)
    val globals = IntArray(code.globals)

    /**
     * Seeded with the clock at the start, rounded to less than millisecond accuracy, since a translation gets there
     * slightly later.
     */
    val random = LejosRandom(robot.milliseconds.toInt() / SEED_MILLISECONDS)

    /** Whether conditions are evaluated: once the variables that they can use are declared. */
    var isWatching = false

    /** While the sensors are being set up, the line that needs the current one; otherwise null. */
    var setUpLine: Int? = null

    /** Whether a `halt` has been executed. */
    var isHalted = false

    private fun eachValue(use: (Int) -> Unit) {
        globals.forEach(use)
        activities().forEach { it.eachValue(use) }
    }

    private companion object {
        /** Translations also divide by it. */
        const val SEED_MILLISECONDS = 64
    }
}

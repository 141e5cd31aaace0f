package robotran.robolang.run

import robotran.rcxrom.program.Rom
import robotran.robolang.messages.RunMessages
import robotran.robolang.robot.Calibration
import robotran.robolang.robot.Durations

/**
 * The state shared by all activities of a run: the robot, the main program's variables, lists, random numbers and the
 * timer.
 */
internal class InterpreterState(val code: Code, val rom: Rom, calibration: Calibration, val messages: RunMessages) {
    val durations = Durations(calibration)
    val commands = RobotCommands(rom)
    val senses = RobotSenses(rom)
    val lists = Lists(messages)
    val globals = IntArray(code.globals)

    /**
     * Seeded with the clock at the start, rounded to less than millisecond accuracy, since a translation gets there
     * slightly later.
     */
    val random = LejosRandom(rom.milliseconds.toInt() / SEED_MILLISECONDS)

    /** Whether conditions are evaluated: once the variables that they can use are declared. */
    var isWatching = false

    /** While the sensors are being set up, the line that needs the current one; otherwise null. */
    var setUpLine: Int? = null

    /** Whether a `halt` has been executed. */
    var isHalted = false

    private companion object {
        /** Translations also divide by it. */
        const val SEED_MILLISECONDS = 64
    }
}

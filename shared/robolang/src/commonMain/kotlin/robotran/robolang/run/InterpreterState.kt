package robotran.robolang.run

import robotran.rcxrom.program.Rom
import robotran.robolang.messages.RunMessages
import robotran.robolang.robot.Calibration
import robotran.robolang.robot.Durations

/**
 * What all activities of a run share: the robot, the variables of the main program, the lists, chance and the timer.
 */
internal class InterpreterState(val code: Code, val rom: Rom, calibration: Calibration, val messages: RunMessages) {
    val durations = Durations(calibration)
    val commands = RobotCommands(rom)
    val senses = RobotSenses(rom)
    val lists = Lists(messages)
    val globals = IntArray(code.globals)

    /**
     * Seeded with the clock at the program's start, and not to the millisecond: a translation gets to it a little later
     * than we do.
     */
    val random = LejosRandom(rom.milliseconds.toInt() / SEED_MILLISECONDS)

    /**
     * Whether the conditions of the behaviours are looked at: from when the variables that they can know are declared.
     */
    var isWatching = false

    /** Whether a `halt` has been executed. */
    var isHalted = false

    private companion object {
        /** Translations divide by it, too. */
        const val SEED_MILLISECONDS = 64
    }
}

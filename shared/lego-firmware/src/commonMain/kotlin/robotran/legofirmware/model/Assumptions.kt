package robotran.legofirmware.model

/**
 * What nobody documents about LEGO's firmware, chosen as simply as possible. docs/lego-firmware.md lists all choices
 * for users.
 */
internal object Assumptions {
    /** The priority that a task has until it sets one. 0 is the highest. */
    const val TASK_PRIORITY = 7

    /** Milliseconds between two refreshes of the display. */
    const val DISPLAY_MILLISECONDS = 100L

    /** Milliseconds after which the figure on the display takes its next step. */
    const val STEP_MILLISECONDS = 500L

    /** Milliseconds between two checks of the battery. */
    const val BATTERY_MILLISECONDS = 60_000L

    /** Milliseconds between two checks of events: the brick reads its sensors as often. */
    const val EVENT_MILLISECONDS = 3L

    /** Milliseconds that a calibration takes. */
    const val CALIBRATION_MILLISECONDS = 50L

    /** The click time of an event that has none, in 10 ms. */
    const val CLICK_TIME = 15

    /** Below so many millivolts NQC warns of a low battery, and the display shows it. */
    const val LOW_BATTERY_MILLIVOLTS = 6600

    /** The greatest count of a loop: the firmware takes one byte. */
    const val LOOP_COUNT = 255

    /** The value that a source has that an RCX does not know. */
    const val UNKNOWN_VALUE = 0

    /** The seed that the firmware begins with; each start of a program adds the milliseconds of the brick's clock. */
    const val RANDOM_SEED = 1

    /** Greatest number of warnings that a run keeps. */
    const val MAX_WARNINGS = 100
}

package robotran.robolang.run

/** Constants of the robot statements; those of the ROM are in [robotran.rcxrom.RomCode]. */
internal object RobotConstants {
    /**
     * The max call depth: leJOS grows a thread's frames by half while there are fewer than 256, from 4 over 141 to 211,
     * and its own threads and the translation's helpers use a few. Source: leJOS `threads.c`.
     */
    const val DEEPEST_CALLS = 200

    /**
     * The max number of elements of all lists: 10 KB of 32-bit words, the least that a brick has left beside a program.
     * An array takes one word besides its elements. Source: reports of leJOS users.
     */
    const val LIST_WORDS = 2500
    const val LIST_HEADER_WORDS = 1

    /** The max power of a motor. */
    const val LARGEST_POWER = 7

    /** The system sound of josx `Sound.buzz()`. */
    const val SOUND_BUZZ = 4

    /** The max duration of a tone in hundredths of a second; a longer one is played in parts. */
    const val LONGEST_TONE = 255
    const val MILLISECONDS_PER_TONE_UNIT = 10

    /** The address of a 16-bit variable for the results of ROM calls. */
    const val RESULT_ADDRESS = 0xE000

    /**
     * The raw battery reading times the numerator, divided by the denominator, is in millivolts. Source: leJOS
     * `Battery.java`.
     */
    const val BATTERY_FACTOR = 43988
    const val BATTERY_DIVISOR = 1560

    /** The interval in milliseconds at which `wait until` and the conditions of waiting behaviours are evaluated. */
    const val LOOKING_MILLISECONDS = 1

    /** The power of a fresh josx `Motor`, 0..7. */
    const val DRIVING_POWER = 3

    /** The power josx `Motor.stop()` brakes with, 0..7. */
    const val BRAKING_POWER = 7

    /** The system sound of josx `Sound.beep()`. */
    const val SOUND_BEEP = 0

    /** The max number of digits after the point on the RCX's LCD. */
    const val LCD_DECIMALS = 3

    /** The max number on the RCX's LCD, ignoring the point. */
    const val LCD_LARGEST = 9999

    /** How long the penbot's pen motor runs to lower or lift the pen, in milliseconds. */
    const val PEN_MILLISECONDS = 200
}

package robotran.robolang.run

/**
 * The figures behind the robot statements that are no matter of the ROM, whose own are in [robotran.rcxrom.RomCode].
 */
internal object RobotConstants {
    /**
     * How many calls may be inside each other: leJOS enlarges the frames of a thread by half as often as they stay
     * below 256, from 4 over 141 to 211, and its own threads and the translation's helpers take a few. Source: leJOS
     * `threads.c`.
     */
    const val DEEPEST_CALLS = 200

    /**
     * How many elements all lists together may have: 10 KB of 32-bit words, the lower end of what a brick has left
     * beside a program; an array takes a word beside its elements. Source: users' reports on leJOS.
     */
    const val LIST_WORDS = 2500
    const val LIST_HEADER_WORDS = 1

    /** The largest power of a motor. */
    const val LARGEST_POWER = 7

    /** The system sound of josx `Sound.buzz()`. */
    const val SOUND_BUZZ = 4

    /** The longest tone there is, in hundredths of a second; a longer one is several, one behind the other. */
    const val LONGEST_TONE = 255
    const val MILLISECONDS_PER_TONE_UNIT = 10

    /** A short in the memory of programs for the results of ROM calls. */
    const val RESULT_ADDRESS = 0xE000

    /** Millivolts are the measured value times the one divided by the other. Source: leJOS `Battery.java`. */
    const val BATTERY_FACTOR = 43988
    const val BATTERY_DIVISOR = 1560

    /** How often `wait until` and the conditions of waiting behaviours are looked at, in milliseconds. */
    const val LOOKING_MILLISECONDS = 1

    /** The ports of the penbot's bumpers and, unless the header names another, of its light sensor. */
    const val LEFT_BUMPER_PORT = 1
    const val RIGHT_BUMPER_PORT = 3
    const val LIGHT_PORT = 2

    /** The power of a fresh josx `Motor`, 0..7. */
    const val DRIVING_POWER = 3

    /** The power josx `Motor.stop()` brakes with, 0..7. */
    const val BRAKING_POWER = 7

    /** The system sound of josx `Sound.beep()`. */
    const val SOUND_BEEP = 0

    /** The most digits the RCX's LCD can have behind the point. */
    const val LCD_DECIMALS = 3

    /** The largest number the RCX's LCD shows, its point left aside. */
    const val LCD_LARGEST = 9999

    /** How long the penbot's pen motor turns to lower or to lift the pen, in milliseconds. */
    const val PEN_MILLISECONDS = 200
}

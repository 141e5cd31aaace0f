package robotran.robolang.run

/** The figures behind the robot statements that are no matter of the ROM, whose own are in [robotran.rom.RomCode]. */
internal object RobotConstants {
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

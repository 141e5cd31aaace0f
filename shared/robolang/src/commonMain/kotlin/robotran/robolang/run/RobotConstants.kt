package robotran.robolang.run

/** The figures behind the robot statements: what josx and the RCX's ROM know them by. All ROM values are unsigned 16-bit. */
internal object RobotConstants {
    /** ROM routine `control motor` (motor, mode, power), behind `Motor.forward()`, `backward()` and `stop()`. */
    const val CONTROL_MOTOR = 0x1a4e

    /** The power of a fresh josx `Motor`, 0..7. */
    const val DRIVING_POWER = 3

    /** The power josx `Motor.stop()` brakes with, 0..7. */
    const val BRAKING_POWER = 7

    /** ROM routine `system sound` (how, which), behind `Sound.beep()`. */
    const val SYSTEM_SOUND = 0x299a

    /** A sound waits for its turn. `rom.h` has this and its opposite the wrong way round; the ROM and josx take 0x4004. */
    const val SOUND_QUEUED = 0x4004

    /** The system sound of `Sound.beep()`. */
    const val SOUND_BEEP = 0

    /** ROM routine `set LCD number` (how, value, point), behind `LCD.setNumber()`. */
    const val SET_LCD_NUMBER = 0x1ff2

    /** `LCDConstants.LCD_SIGNED`: no leading zeros, a minus where it belongs, nothing beyond 9999. */
    const val LCD_SIGNED = 0x3001

    /** `LCDConstants.LCD_DECIMAL_0`: no point. One digit more behind the point is one more: 0x3003..0x3005. */
    const val LCD_DECIMAL_0 = 0x3002

    /** Most digits the LCD can have behind the point. */
    const val LCD_DECIMALS = 3

    /** The largest number the LCD shows, whatever the point. */
    const val LCD_LARGEST = 9999

    /** ROM routine `refresh display`, behind `LCD.refresh()`. */
    const val REFRESH_DISPLAY = 0x27c8

    /** How long the pen motor turns to lower or to lift the pen, in milliseconds; a property of the penbot. */
    const val PEN_MILLISECONDS = 200
}

package robotran.rom

/**
 * Where the ROM's routines begin, for [RomCall.address]. Sources: leJOS `rom.h` (Kekoa Proudfoot) and `josx.platform.rcx`.
 */
object RomAddress {
    /** Arguments: sensor 0x1000..0x1002, pointer to a `sensor_t` whose type and mode are set. */
    const val READ_SENSOR = 0x14C0

    /** Argument: sensor 0x1000..0x1002. */
    const val ACTIVATE_SENSOR = 0x1946

    /** Argument: sensor 0x1000..0x1002. */
    const val PASSIVATE_SENSOR = 0x19C4

    /** Arguments: motor 0x2000..0x2002, mode 1..4, power 0..7. See [MotorPort], [MotorMode]. */
    const val CONTROL_MOTOR = 0x1A4E

    /** Argument: segment code, see [RomCode]. */
    const val SET_LCD_SEGMENT = 0x1B62

    /** Argument: segment code, see [RomCode]. */
    const val CLEAR_LCD_SEGMENT = 0x1E4A

    /** Arguments: 0x3000, pointer to a short that gets 1 for Run, 2 for View, 4 for Prgm, added up. */
    const val READ_BUTTONS = 0x1FB6

    /** Arguments: how to show it, the number, where its point is; see [RomCode]. */
    const val SET_LCD_NUMBER = 0x1FF2

    /** No arguments. */
    const val CLEAR_LCD = 0x27AC

    /** No arguments. Nothing written to the LCD is visible before. */
    const val REFRESH_LCD = 0x27C8

    /** Arguments: [RomCode.SOUND_NOW] or [RomCode.SOUND_QUEUED], system sound 0..5. */
    const val PLAY_SYSTEM_SOUND = 0x299A

    /** Arguments: [RomCode.ON_OFF_KEY] or [RomCode.BATTERY], pointer to a short. */
    const val READ_POWER_STATUS = 0x29F2

    /** Arguments: [RomCode.TONE], hertz, hundredths of a second; or [RomCode.TONE_SYSTEM_SOUND], anything, system sound 0..5. */
    const val PLAY_TONE = 0x327C

    /** Arguments: 0x700c, pointer to a byte that gets 1 while sounds are played or wait, otherwise 0. */
    const val READ_SOUND_PLAYING = 0x3CCC
}

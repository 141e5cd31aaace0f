package robotran.rcxrom.call

/**
 * Start addresses of the ROM's routines, for [RomCall.address]. Sources: leJOS `rom.h` (Kekoa Proudfoot) and
 * `josx.platform.rcx`.
 */
object RomAddress {
    /** No arguments. Allows the sensor ports to be powered. */
    const val INIT_SENSORS = 0x1498

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

    /** Arguments: 0x3000, pointer to a short that receives the sum of 1 for Run, 2 for View, 4 for Prgm. */
    const val READ_BUTTONS = 0x1FB6

    /** Arguments: number format, number, position of the decimal point; see [RomCode]. */
    const val SET_LCD_NUMBER = 0x1FF2

    /** No arguments. */
    const val CLEAR_LCD = 0x27AC

    /** No arguments. Makes what was written to the LCD visible. */
    const val REFRESH_LCD = 0x27C8

    /** Arguments: [RomCode.SOUND_NOW] or [RomCode.SOUND_QUEUED], system sound 0..5. */
    const val PLAY_SYSTEM_SOUND = 0x299A

    /** Arguments: [RomCode.ON_OFF_KEY] or [RomCode.BATTERY], pointer to a short. */
    const val READ_POWER_STATUS = 0x29F2

    /**
     * Arguments: [RomCode.TONE], hertz, hundredths of a second; or [RomCode.TONE_SYSTEM_SOUND], any value, system sound
     * 0..5.
     */
    const val PLAY_TONE = 0x327C

    /** Arguments: 0x700c, pointer to a byte that receives 1 while sounds play or wait, otherwise 0. */
    const val READ_SOUND_PLAYING = 0x3CCC

    /** No arguments. Switches the power of all sensor ports off. */
    const val SHUTDOWN_SENSORS = 0x1A22

    /** No arguments; does nothing on a real brick. */
    const val INIT_MOTORS = 0x1A4A
    const val SHUTDOWN_MOTORS = 0x1AB4

    /** No arguments. Also clears the LCD's memory. */
    const val INIT_BUTTONS = 0x1ABA

    /** No arguments. */
    const val SHUTDOWN_BUTTONS = 0x27F4

    /** Argument: [RomCode.VIEW_BUTTON_SOUND]. */
    const val PLAY_VIEW_BUTTON_SOUND = 0x1B32

    /** No arguments. */
    const val INIT_POWER = 0x2964

    /** No arguments. The processor sleeps until On-Off is pressed. */
    const val POWER_OFF = 0x2A62

    /**
     * Arguments: pointer to a byte whose bit 7 is set when a message arrives, pointer to the receive timer, 1, 1. leJOS
     * passes 0 and 0.
     */
    const val INIT_SERIAL = 0x30D0

    /** No arguments. */
    const val SHUTDOWN_SERIAL = 0x3636

    /** Argument: [RomCode.RANGE]. */
    const val SET_RANGE_LONG = 0x3250
    const val SET_RANGE_SHORT = 0x3266

    /** Argument: any value. */
    const val RESET_MINUTE_TIMER = 0x339A

    /** Arguments: pointer to a buffer, its length, pointer to a byte that is increased by the number of bytes. */
    const val RECEIVE_DATA = 0x33B0

    /**
     * Arguments: pointer to a byte that gets 1 if a message waits, pointer to a short that gets the transfer pointer,
     * or 0.
     */
    const val CHECK_FOR_DATA = 0x3426

    /**
     * Arguments: [RomCode.SEND_SHORT] or [RomCode.SEND_LONG], opcode of the request that a long message answers,
     * pointer to the bytes, byte count.
     */
    const val SEND_DATA = 0x343E

    /** No arguments. The purpose of this pin is unknown. */
    const val INIT_PORT_6_BIT_3 = 0x3692
    const val SHUTDOWN_PORT_6_BIT_3 = 0x36AA

    /** Arguments: pointer to the firmware's timers, see [FirmwareTimers]; pointer to its flags. */
    const val INIT_TIMER = 0x3B9A

    /** Arguments: 0x7001..0x7003, pointer to two bytes: power and mode. */
    const val CONTROL_MOTOR_INTERNALLY = 0x3CE6

    /**
     * Arguments: [RomCode.OUTPUT_SENSORS], bits of the ports; or [RomCode.OUTPUT_SOUND], [RomCode.OUTPUT_SOUND_NOW],
     * kind, value, control.
     */
    const val CONTROL_OUTPUT = 0x3DE0

    /** Arguments: [RomCode.OUTPUT_SENSORS], bits of the ports; or [RomCode.OUTPUT_MINUTE_TIMER]. */
    const val CLEAR_OUTPUT = 0x3E9E

    /** No arguments. Motors, sounds and sensors stop until [INIT_TIMER]. */
    const val SHUTDOWN_TIMER = 0x3ED4
}

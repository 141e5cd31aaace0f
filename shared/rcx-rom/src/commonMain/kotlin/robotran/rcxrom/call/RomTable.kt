package robotran.rcxrom.call

import robotran.brick.log.CallGroup

/** The kind of an argument; decides how the log formats it and how the routine checks it. */
internal enum class RomParameter { CODE, NUMBER, POINTER }

/**
 * What is known about a routine.
 *
 * @property codeGroup required high byte of the first argument; null if the routine does not check it.
 * @property parameters the required arguments.
 * @property gap why the virtual brick does not implement the routine; null if it does.
 */
internal data class RomSignature(
    val address: Int,
    val name: String,
    val group: CallGroup,
    val codeGroup: Int?,
    val parameters: List<RomParameter>,
    val gap: RomGap?,
)

/**
 * The routines that leJOS and its virtual machine call, and related ones. Source: leJOS `rom.h`; the code groups are
 * from brickEmu's ROM re-implementation.
 */
internal object RomTable {
    private const val SENSOR_CODES = 0x10
    private const val SERIAL_AND_TONE_CODES = 0x17
    private const val MOTOR_CODES = 0x20
    private const val BUTTON_AND_LCD_CODES = 0x30
    private const val POWER_CODES = 0x40
    private const val INTERNAL_CODES = 0x70

    private val code = RomParameter.CODE
    private val number = RomParameter.NUMBER
    private val pointer = RomParameter.POINTER

    private val all: List<RomSignature> = listOf(
        routine(RomAddress.INIT_SENSORS, "init sensors", CallGroup.SENSORS),
        routine(RomAddress.READ_SENSOR, "read sensor", CallGroup.SENSORS, SENSOR_CODES, code, pointer),
        routine(RomAddress.ACTIVATE_SENSOR, "sensor active", CallGroup.SENSORS, SENSOR_CODES, code),
        routine(RomAddress.PASSIVATE_SENSOR, "sensor passive", CallGroup.SENSORS, SENSOR_CODES, code),
        routine(RomAddress.SHUTDOWN_SENSORS, "shutdown sensors", CallGroup.SENSORS),
        routine(RomAddress.INIT_MOTORS, "init motors", CallGroup.MOTORS),
        routine(RomAddress.CONTROL_MOTOR, "control motor", CallGroup.MOTORS, MOTOR_CODES, code, number, number),
        routine(RomAddress.SHUTDOWN_MOTORS, "shutdown motors", CallGroup.MOTORS),
        routine(RomAddress.INIT_BUTTONS, "init buttons", CallGroup.BUTTONS),
        routine(
            RomAddress.PLAY_VIEW_BUTTON_SOUND,
            "play view button sound",
            CallGroup.SOUND,
            BUTTON_AND_LCD_CODES,
            code,
        ),
        routine(RomAddress.SET_LCD_SEGMENT, "set LCD segment", CallGroup.DISPLAY, BUTTON_AND_LCD_CODES, code),
        routine(RomAddress.CLEAR_LCD_SEGMENT, "clear LCD segment", CallGroup.DISPLAY, BUTTON_AND_LCD_CODES, code),
        routine(RomAddress.READ_BUTTONS, "read buttons", CallGroup.BUTTONS, BUTTON_AND_LCD_CODES, code, pointer),
        routine(
            RomAddress.SET_LCD_NUMBER,
            "set LCD number",
            CallGroup.DISPLAY,
            BUTTON_AND_LCD_CODES,
            code,
            number,
            code,
        ),
        routine(RomAddress.CLEAR_LCD, "clear LCD", CallGroup.DISPLAY),
        routine(RomAddress.REFRESH_LCD, "refresh LCD", CallGroup.DISPLAY),
        routine(RomAddress.SHUTDOWN_BUTTONS, "shutdown buttons", CallGroup.BUTTONS),
        routine(RomAddress.INIT_POWER, "init power", CallGroup.POWER),
        routine(RomAddress.PLAY_SYSTEM_SOUND, "play system sound", CallGroup.SOUND, POWER_CODES, code, number),
        routine(RomAddress.READ_POWER_STATUS, "read power status", CallGroup.POWER, POWER_CODES, code, pointer),
        routine(RomAddress.POWER_OFF, "power off", CallGroup.POWER),
        routine(RomAddress.INIT_SERIAL, "init serial", CallGroup.INFRARED, null, pointer, pointer, number, number),
        routine(RomAddress.SET_RANGE_LONG, "set infrared range long", CallGroup.INFRARED, SERIAL_AND_TONE_CODES, code),
        routine(
            RomAddress.SET_RANGE_SHORT,
            "set infrared range short",
            CallGroup.INFRARED,
            SERIAL_AND_TONE_CODES,
            code,
        ),
        routine(RomAddress.PLAY_TONE, "play tone", CallGroup.SOUND, SERIAL_AND_TONE_CODES, code, number, number),
        routine(RomAddress.RESET_MINUTE_TIMER, "reset minute timer", CallGroup.TIMER),
        routine(RomAddress.RECEIVE_DATA, "receive data", CallGroup.INFRARED, null, pointer, number, pointer),
        routine(RomAddress.CHECK_FOR_DATA, "check for data", CallGroup.INFRARED, null, pointer, pointer),
        routine(
            RomAddress.SEND_DATA,
            "send data",
            CallGroup.INFRARED,
            SERIAL_AND_TONE_CODES,
            code,
            number,
            pointer,
            number,
        ),
        routine(RomAddress.SHUTDOWN_SERIAL, "shutdown serial", CallGroup.INFRARED),
        routine(RomAddress.INIT_PORT_6_BIT_3, "init port 6 bit 3", CallGroup.POWER),
        routine(RomAddress.SHUTDOWN_PORT_6_BIT_3, "shutdown port 6 bit 3", CallGroup.POWER),
        routine(0x36BA, "handle timer tick", CallGroup.TIMER).copy(gap = RomGap.TIMER_TICK),
        routine(RomAddress.INIT_TIMER, "init timer", CallGroup.TIMER, null, pointer, pointer),
        routine(RomAddress.READ_SOUND_PLAYING, "read sound playing", CallGroup.SOUND, INTERNAL_CODES, code, pointer),
        routine(
            RomAddress.CONTROL_MOTOR_INTERNALLY,
            "control motor internally",
            CallGroup.MOTORS,
            INTERNAL_CODES,
            code,
            pointer,
        ),
        routine(RomAddress.CONTROL_OUTPUT, "control output", CallGroup.TIMER, INTERNAL_CODES, code, number),
        routine(RomAddress.CLEAR_OUTPUT, "clear output", CallGroup.TIMER, INTERNAL_CODES, code),
        routine(RomAddress.SHUTDOWN_TIMER, "shutdown timer", CallGroup.TIMER),
    )

    private val byAddress: Map<Int, RomSignature> = all.associateBy { it.address }

    /** All known routines. */
    val signatures: Collection<RomSignature> get() = byAddress.values

    /** The routine that starts at [address]; null if none is known. */
    fun find(address: Int): RomSignature? = byAddress[address]

    /**
     * The group of the routine at [address]. Routine 0x327c, which also sets the infrared pointer, counts as
     * [CallGroup.SOUND].
     */
    fun groupOf(address: Int): CallGroup = find(address)?.group ?: CallGroup.UNKNOWN

    private fun routine(
        address: Int,
        name: String,
        group: CallGroup,
        codeGroup: Int? = null,
        vararg parameters: RomParameter,
    ) = RomSignature(address, name, group, codeGroup, parameters.toList(), gap = null)
}

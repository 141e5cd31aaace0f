package robotran.rom

/** What an argument of a routine is, which decides how a log writes it and how a routine checks it. */
internal enum class RomParameter { CODE, NUMBER, POINTER }

/**
 * What is known of a routine.
 *
 * @property codeGroup the high byte that the routine wants in its first argument; null if it does not look.
 */
internal data class RomSignature(
    val address: Int,
    val name: String,
    val codeGroup: Int?,
    val parameters: List<RomParameter>,
)

/**
 * The routines that leJOS and its virtual machine call, and those beside them. Source: leJOS `rom.h`; the groups of codes from the
 * re-implemented ROM of brickEmu.
 */
internal object RomTable {
    private const val SENSORS = 0x10
    private const val SERIAL_AND_TONES = 0x17
    private const val MOTORS = 0x20
    private const val BUTTONS_AND_LCD = 0x30
    private const val POWER = 0x40
    private const val INTERNAL = 0x70

    private val code = RomParameter.CODE
    private val number = RomParameter.NUMBER
    private val pointer = RomParameter.POINTER

    private val all: List<RomSignature> = listOf(
        routine(0x1498, "init sensors"),
        routine(RomAddress.READ_SENSOR, "read sensor", SENSORS, code, pointer),
        routine(RomAddress.ACTIVATE_SENSOR, "sensor active", SENSORS, code),
        routine(RomAddress.PASSIVATE_SENSOR, "sensor passive", SENSORS, code),
        routine(0x1A22, "shutdown sensors"),
        routine(0x1A4A, "init motors"),
        routine(RomAddress.CONTROL_MOTOR, "control motor", MOTORS, code, number, number),
        routine(0x1AB4, "shutdown motors"),
        routine(0x1ABA, "init buttons"),
        routine(0x1B32, "play view button sound", BUTTONS_AND_LCD, code),
        routine(RomAddress.SET_LCD_SEGMENT, "set LCD segment", BUTTONS_AND_LCD, code),
        routine(RomAddress.CLEAR_LCD_SEGMENT, "clear LCD segment", BUTTONS_AND_LCD, code),
        routine(RomAddress.READ_BUTTONS, "read buttons", BUTTONS_AND_LCD, code, pointer),
        routine(RomAddress.SET_LCD_NUMBER, "set LCD number", BUTTONS_AND_LCD, code, number, code),
        routine(RomAddress.CLEAR_LCD, "clear LCD"),
        routine(RomAddress.REFRESH_LCD, "refresh LCD"),
        routine(0x27F4, "shutdown buttons"),
        routine(0x2964, "init power"),
        routine(RomAddress.PLAY_SYSTEM_SOUND, "play system sound", POWER, code, number),
        routine(RomAddress.READ_POWER_STATUS, "read power status", POWER, code, pointer),
        routine(0x2A62, "power off"),
        routine(0x30D0, "init serial", null, pointer, pointer, number, number),
        routine(0x3250, "set infrared range long", SERIAL_AND_TONES, code),
        routine(0x3266, "set infrared range short", SERIAL_AND_TONES, code),
        routine(RomAddress.PLAY_TONE, "play tone", SERIAL_AND_TONES, code, number, number),
        routine(0x339A, "reset minute timer"),
        routine(0x33B0, "receive data", null, pointer, number, pointer),
        routine(0x3426, "check for data", null, pointer, pointer),
        routine(0x343E, "send data", SERIAL_AND_TONES, code, number, pointer, number),
        routine(0x3636, "shutdown serial"),
        routine(0x3692, "init port 6 bit 3"),
        routine(0x36AA, "shutdown port 6 bit 3"),
        routine(0x36BA, "handle timer tick"),
        routine(0x3B9A, "init timer", null, pointer, pointer),
        routine(RomAddress.READ_SOUND_PLAYING, "read sound playing", INTERNAL, code, pointer),
        routine(0x3CE6, "control motor internally", INTERNAL, code, pointer),
        routine(0x3DE0, "control output", INTERNAL, code),
        routine(0x3E9E, "clear output", INTERNAL, code),
        routine(0x3ED4, "shutdown timer"),
    )

    private val byAddress: Map<Int, RomSignature> = all.associateBy { it.address }

    /** Every routine known. */
    val signatures: Collection<RomSignature> get() = byAddress.values

    /** The routine that begins at [address], if one is known. */
    fun find(address: Int): RomSignature? = byAddress[address]

    private fun routine(address: Int, name: String, codeGroup: Int? = null, vararg parameters: RomParameter) =
        RomSignature(address, name, codeGroup, parameters.toList())
}

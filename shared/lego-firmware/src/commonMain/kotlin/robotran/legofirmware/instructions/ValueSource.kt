package robotran.legofirmware.instructions

import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.FirmwareTarget.RCX
import robotran.legofirmware.image.FirmwareTarget.RCX2

/**
 * Where an instruction gets a value from.
 *
 * @property code its number in an instruction.
 * @property listingName its name in a listing.
 * @property firmware the first that knows it.
 * @property isWritable whether `set` can write to it.
 */
enum class ValueSource(
    val code: Int,
    val listingName: String,
    val firmware: FirmwareTarget = RCX,
    val isWritable: Boolean = false,
) {
    /** A variable, by its number. */
    VARIABLE(0, "var", isWritable = true),

    /** A timer 0..3 in 100 ms. */
    TIMER(1, "Timer", isWritable = true),

    /** The argument itself. */
    CONSTANT(2, "const"),

    /** The state of motor 0..2 as a byte. */
    OUTPUT(3, "Output"),

    /** A random number from 0 to the argument; writing seeds it. */
    RANDOM(4, "Random", isWritable = true),

    /** The selected slot, 0..4; writing selects one. */
    PROGRAM(8, "Program", isWritable = true),

    /** The value of sensor 0..2 in its mode. */
    INPUT(9, "Input"),

    /** The type of sensor 0..2. */
    SENSOR_TYPE(10, "SensorType", isWritable = true),

    /** The mode of sensor 0..2 with its slope. */
    SENSOR_MODE(11, "SensorMode", isWritable = true),

    /** The raw value of sensor 0..2, 0..1023. */
    SENSOR_RAW(12, "SensorRaw"),

    /** The boolean value of sensor 0..2. */
    SENSOR_BOOLEAN(13, "SensorBool"),

    /** Minutes on the watch. */
    WATCH(14, "Watch", isWritable = true),

    /** The last message from another brick, 0 if none. */
    MESSAGE(15, "Message", isWritable = true),

    /** The state of motor 0..2 in the global layer, as a byte. */
    GLOBAL_OUTPUT(17, "GlobalOutput", RCX2),

    /** A counter 0..2, which is the variable with that number. */
    COUNTER(21, "Counter", RCX2, isWritable = true),

    /** The mask of events that fired for a task 0..9; 10 is the running one. */
    ACTIVE_EVENTS(23, "ActiveEvents", RCX2),

    /** The state of an event 0..15. */
    EVENT_STATE(25, "EventState", RCX2),

    /** A timer 0..3 in 10 ms. */
    FAST_TIMER(26, "FastTimer", RCX2, isWritable = true),

    /** The clicks of an event 0..15. */
    CLICK_COUNTER(27, "ClickCounter", RCX2, isWritable = true),

    UPPER_LIMIT(28, "UpperLimit", RCX2, isWritable = true),
    LOWER_LIMIT(29, "LowerLimit", RCX2, isWritable = true),
    HYSTERESIS(30, "Hysteresis", RCX2, isWritable = true),

    /** The click time of an event 0..15 in 10 ms. */
    CLICK_TIME(31, "ClickTime", RCX2, isWritable = true),

    /** The serial buffer: bytes 0..15, 16 the format of packets, 17 the carrier. */
    UART(33, "uart", RCX2, isWritable = true),

    /** Millivolts of the battery. */
    BATTERY_LEVEL(34, "BatteryLevel", RCX2),

    /** Such as 328. */
    FIRMWARE_VERSION(35, "FirmwareVersion", RCX2),

    /** The variable whose number is in the variable of the argument. */
    INDIRECT(36, "*var", RCX2, isWritable = true),

    LOG_TYPE_INDIRECT(37, "LogTypeInd", RCX2, isWritable = true),
    LOG_TYPE(38, "LogTypeDir", RCX2, isWritable = true),
    LOG_VALUE_INDIRECT(39, "LogValInd", RCX2, isWritable = true),
    LOG_VALUE(40, "LogValDir", RCX2, isWritable = true),
    LOG_BYTE_INDIRECT(41, "LogByteInd", RCX2, isWritable = true),
    LOG_BYTE(42, "LogByteDir", RCX2, isWritable = true),
    ;

    companion object {
        /** The greatest number of a source of any of LEGO's bricks. */
        const val GREATEST_CODE = 42

        private val byCode = entries.associateBy { it.code }

        /** The source with this [code]; null if an RCX does not have it. */
        fun of(code: Int): ValueSource? = byCode[code]
    }
}

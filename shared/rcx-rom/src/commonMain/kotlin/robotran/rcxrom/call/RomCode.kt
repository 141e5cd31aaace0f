package robotran.rcxrom.call

/**
 * The codes that select a function of a ROM routine. Sources: leJOS `rom.h`, `LCDConstants.java`, `Segment.java`,
 * `Sound.java`. On queued sounds `rom.h` contradicts its own comment; `Sound.java` is right.
 */
object RomCode {
    /** [RomAddress.SET_LCD_NUMBER]: without leading zeros, from -9999 to 9999. */
    const val LCD_SIGNED = 0x3001

    /** [RomAddress.SET_LCD_NUMBER]: four digits, from 0 to 9999; the number is unsigned. */
    const val LCD_UNSIGNED = 0x301F

    /** [RomAddress.SET_LCD_NUMBER]: the program digit, 0 to 9. */
    const val LCD_PROGRAM = 0x3017

    /** No decimal point; the codes for one, two and three decimals follow. */
    const val LCD_POINT_NONE = 0x3002
    const val LCD_POINT_1 = 0x3003
    const val LCD_POINT_2 = 0x3004
    const val LCD_POINT_3 = 0x3005

    const val SEGMENT_STANDING_MAN = 0x3006
    const val SEGMENT_WALKING_MAN = 0x3007

    /** The first of the sensor and motor segments, in the order of [LcdIcon]. */
    const val SEGMENT_SENSOR_1_VIEW = 0x3008
    const val SEGMENT_MOTOR_C_FORWARD = 0x3016
    const val SEGMENT_DATALOG = 0x3018
    const val SEGMENT_DOWNLOAD = 0x3019
    const val SEGMENT_UPLOAD = 0x301A
    const val SEGMENT_LOW_BATTERY = 0x301B
    const val SEGMENT_INFRARED_SHORT = 0x301C
    const val SEGMENT_INFRARED_LONG = 0x301D
    const val SEGMENT_ALL = 0x3020

    const val BUTTONS = 0x3000

    const val ON_OFF_KEY = 0x4000
    const val BATTERY = 0x4001

    /** Clears the queue, cuts off the current sound and plays at once. */
    const val SOUND_NOW = 0x4003
    const val SOUND_QUEUED = 0x4004

    const val TONE_DATA_POINTER = 0x1771
    const val TONE_SYSTEM_SOUND = 0x1772
    const val TONE = 0x1773

    const val SOUND_PLAYING = 0x700C

    const val VIEW_BUTTON_SOUND = 0x301E

    /** [RomAddress.SET_RANGE_LONG], [RomAddress.SET_RANGE_SHORT]. */
    const val RANGE = 0x1770

    /** [RomAddress.SEND_DATA]: the routine copies the bytes, then sends them; the first byte is the opcode. */
    const val SEND_SHORT = 0x1775

    /** [RomAddress.SEND_DATA]: an answer; its bytes are read from memory during transmission. */
    const val SEND_LONG = 0x1776

    /** [RomAddress.CONTROL_MOTOR_INTERNALLY]: motor A; the codes of B and C follow. */
    const val INTERNAL_MOTOR_A = 0x7001

    const val OUTPUT_SENSORS = 0x700A
    const val OUTPUT_SOUND = 0x700B
    const val OUTPUT_SOUND_NOW = 0x700D
    const val OUTPUT_MINUTE_TIMER = 0x700E
}

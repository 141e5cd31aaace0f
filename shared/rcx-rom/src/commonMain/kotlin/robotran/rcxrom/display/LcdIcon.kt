package robotran.rcxrom.display

/**
 * Everything on the LCD that is not part of a seven-segment digit. An icon is lit when all its segments are; the two
 * men share the body. Memory addresses: brickOS `dlcd.h`, leJOS `Segment.java`.
 */
enum class LcdIcon(internal val segments: List<LcdSegment>) {
    STANDING_MAN(listOf(LcdSegment(0xEF43, 1), LcdSegment(0xEF43, 2))),
    WALKING_MAN(listOf(LcdSegment(0xEF43, 0), LcdSegment(0xEF43, 1), LcdSegment(0xEF43, 3))),

    /** The little arrow that points at the input port. */
    SENSOR_1_VIEW(0xEF49, 0),

    /** The mark that the port is powered. */
    SENSOR_1_ACTIVE(0xEF49, 1),
    SENSOR_2_VIEW(0xEF48, 4),
    SENSOR_2_ACTIVE(0xEF48, 0),
    SENSOR_3_VIEW(0xEF47, 4),
    SENSOR_3_ACTIVE(0xEF45, 4),

    /** The little arrow that points at the output port. */
    MOTOR_A_VIEW(0xEF4A, 2),
    MOTOR_A_BACKWARD(0xEF46, 6),
    MOTOR_A_FORWARD(0xEF46, 2),
    MOTOR_B_VIEW(0xEF43, 6),
    MOTOR_B_BACKWARD(0xEF44, 2),
    MOTOR_B_FORWARD(0xEF47, 2),
    MOTOR_C_VIEW(0xEF44, 6),
    MOTOR_C_BACKWARD(0xEF47, 6),
    MOTOR_C_FORWARD(0xEF45, 6),

    /** The quarters of the data log's circle, clockwise. */
    DATALOG_TOP_RIGHT(0xEF45, 0),
    DATALOG_BOTTOM_RIGHT(0xEF45, 2),
    DATALOG_BOTTOM_LEFT(0xEF45, 3),
    DATALOG_TOP_LEFT(0xEF45, 1),

    /** The row of dots of a transfer, from the left. */
    DOT_1(0xEF4A, 4),
    DOT_2(0xEF4A, 0),
    DOT_3(0xEF4B, 4),
    DOT_4(0xEF4B, 0),
    DOT_5(0xEF49, 4),

    /** The crossed-out battery. */
    LOW_BATTERY(0xEF47, 0),

    /** The near infrared waves, lit at both ranges. */
    INFRARED_SHORT(0xEF49, 2),

    /** The far infrared waves, lit together with the near ones at long range. */
    INFRARED_LONG(0xEF49, 3),

    /** The minus sign to the left of the four digits of the main number. */
    MINUS(0xEF4A, 6),

    /** The decimal point before the last digit of the main number, between the digits at positions 2 and 1. */
    POINT_1(0xEF48, 6),

    /** The decimal point before the last two digits of the main number. */
    POINT_2(0xEF49, 6),

    /** The decimal point before the last three digits of the main number. */
    POINT_3(0xEF4B, 6),
    ;

    constructor(address: Int, bit: Int) : this(listOf(LcdSegment(address, bit)))

    /** The icon's name within a sentence, such as `motor A forward`. */
    val words: String
        get() = name.split('_').joinToString(" ") { if (it.length == 1) it else it.lowercase() }
}

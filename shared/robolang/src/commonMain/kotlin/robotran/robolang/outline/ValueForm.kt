package robotran.robolang.outline

import robotran.brick.kind.BrickKind

/** The kinds of values. */
enum class ValueForm {
    NUMBER,

    /** `true`, `false`. */
    TRUTH,

    /** `[1, 2, 3]`. */
    LIST,

    /** A constant, a variable or a parameter. */
    NAME,

    /** `list[0]`. */
    ELEMENT,

    /** `-x`. */
    NEGATION,

    NOT,

    /** `a and b`, `a or b`. */
    LOGIC,

    /** `a < b`. */
    COMPARISON,

    /** `a + b`. */
    ARITHMETIC,

    /** A call of a function that the program declares, or of an unknown one. */
    CALL,

    /** A call of a function of the language. */
    BUILT_IN,

    BUMPER,

    LIGHT,

    /** `sensor 1`. */
    SENSOR,

    BUTTON,

    TIMER,

    BATTERY,

    /** `distance`, of the ultrasonic sensor. */
    DISTANCE,

    /** `loudness`, of the sound sensor. */
    LOUDNESS,

    /** `colour`, of the colour sensor. */
    COLOUR,

    /** `red` and the other colours. */
    COLOUR_NAME,

    /** `turned A`. */
    TURNED,

    /** `(x)`. */
    BRACKETS,
    ;

    /** The only brick that it is for; null for both. */
    val brick: BrickKind? get() = if (this in FOR_NXT) BrickKind.NXT else null

    private companion object {
        val FOR_NXT = setOf(DISTANCE, LOUDNESS, COLOUR, COLOUR_NAME, TURNED)
    }
}

/** The types of values, as far as a beginner meets them. */
enum class ValueKind { NUMBER, CONDITION, LIST, COLOUR, UNKNOWN }

/**
 * What a value is for.
 *
 * @property kind the type that fits; [ValueKind.UNKNOWN] if several do.
 * @property unit its unit as the language writes it; null if it has none. Hertz have no word in the language.
 * @property example a value that makes sense there.
 */
enum class ValueUse(val kind: ValueKind, val unit: String?, val example: String) {
    DISTANCE(ValueKind.NUMBER, "cm", "20"),
    ANGLE(ValueKind.NUMBER, "degrees", "90"),
    SECONDS(ValueKind.NUMBER, "seconds", "1"),
    MILLISECONDS(ValueKind.NUMBER, "milliseconds", "500"),

    /** A motor's power, 0..7. */
    POWER(ValueKind.NUMBER, null, "5"),
    FREQUENCY(ValueKind.NUMBER, "Hz", "440"),
    COUNT(ValueKind.NUMBER, "times", "4"),
    NUMBER(ValueKind.NUMBER, null, "5"),

    /** A number, or a colour where there is a colour sensor. */
    SHOWN(ValueKind.NUMBER, null, "5"),

    /** The place of an element, from 0. */
    INDEX(ValueKind.NUMBER, null, "0"),
    CONDITION(ValueKind.CONDITION, null, "left bumper"),
    LIST(ValueKind.LIST, null, "[1, 2, 3]"),

    /** A number or a condition, as both sides of `==`. */
    ANY(ValueKind.UNKNOWN, null, "5"),
}

package robotran.robolang.words

import robotran.brick.kind.BrickKind

/**
 * The kinds of values.
 *
 * @property marked such a value, which makes sense; null if it has names of the pupil's, or if there are several. Two
 * `|` enclose what a pupil writes first.
 * @property needs what a brick must have for it; null if every one does.
 */
enum class ValueForm(
    val marked: String?,
    val group: BlockGroup,
    private val needs: BrickFeature? = null,
    private val exampleWith: Pair<BrickFeature, String>? = null,
) {
    NUMBER("5", BlockGroup.NUMBERS),

    /** `true`, `false`. */
    TRUTH("true", BlockGroup.CONTROL),
    LIST("[1, 2, 3]", BlockGroup.LISTS),

    /** A constant, a variable or a parameter. */
    NAME(null, BlockGroup.NUMBERS),

    /** `list[0]`. */
    ELEMENT(null, BlockGroup.LISTS),
    NEGATION("-light", BlockGroup.NUMBERS),
    NOT("not left bumper", BlockGroup.CONTROL),

    /** `a and b`, `a or b`. */
    LOGIC("left bumper and right bumper", BlockGroup.CONTROL),
    COMPARISON("light < 40", BlockGroup.CONTROL, exampleWith = BrickFeature.SONAR to "distance < 20"),
    ARITHMETIC("5 + 5", BlockGroup.NUMBERS),

    /** A call of a function that the program declares, or of an unknown one. */
    CALL(null, BlockGroup.OWN_COMMANDS),

    /** A call of a function of the language. */
    BUILT_IN(null, BlockGroup.NUMBERS),
    BUMPER("left bumper", BlockGroup.SENSE),
    LIGHT("light", BlockGroup.SENSE),
    SENSOR("sensor |1|", BlockGroup.SENSE),
    BUTTON("button run", BlockGroup.SENSE, exampleWith = BrickFeature.ENTER_BUTTON to "button enter"),
    TIMER("timer", BlockGroup.SENSE),
    BATTERY("battery", BlockGroup.SENSE),

    /** Of the ultrasonic sensor. */
    DISTANCE("distance", BlockGroup.SENSE, BrickFeature.SONAR),

    /** Of the sound sensor. */
    LOUDNESS("loudness", BlockGroup.SENSE, BrickFeature.SOUND_SENSOR),

    /** Of the colour sensor. */
    COLOUR("colour", BlockGroup.SENSE, BrickFeature.COLOUR_SENSOR),

    /** `red` and the other colours. */
    COLOUR_NAME("red", BlockGroup.SENSE, BrickFeature.COLOUR_SENSOR),
    TURNED("turned |A|", BlockGroup.SENSE, BrickFeature.MOTOR_COUNTERS),
    BRACKETS("(5)", BlockGroup.NUMBERS),
    ;

    /** [marked] without its marks. */
    val example: String? = marked?.replace("|", "")

    /** The example for a robot with [brick]; null if there is none. */
    fun exampleOn(brick: BrickKind): String? = when {
        needs?.isOn(brick) == false -> null
        exampleWith?.first?.isOn(brick) == true -> exampleWith.second
        else -> example
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

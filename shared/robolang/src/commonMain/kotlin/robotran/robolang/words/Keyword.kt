package robotran.robolang.words

import robotran.brick.kind.BrickKind

/**
 * The keywords; they ignore case. Each has a row in [KEYWORD_TABLE]. Completion offers those that begin values in this order.
 *
 * @property text its usual spelling in English, which the code knows it by; [Vocabulary] has all spellings.
 * @property isFree whether a pupil may use the word as a name, since it stands only where no name can.
 * @property yields whether it is a name in a program that declares it as one: the words that came later.
 * @property needs what a brick must have for it; null if every one does.
 * @property beginsValue whether an expression can begin with it.
 * @property endsValue whether it can end an expression, so that a minus after it subtracts.
 */
internal enum class Keyword(
    val text: String,
    val isFree: Boolean = false,
    val beginsValue: Boolean = false,
    val endsValue: Boolean = false,
    val yields: Boolean = false,
    val needs: BrickFeature? = null,
) {
    FORWARD("forward"),
    BACKWARD("backward"),
    TURN("turn"),
    START("start"),
    STOP("stop"),
    POWER("power"),
    MOTOR("motor"),
    PEN("pen"),
    WAIT("wait"),
    RESET("reset"),
    BEEP("beep"),
    BUZZ("buzz"),
    PLAY("play"),
    SHOW("show"),
    CLEAR("clear"),
    REPEAT("repeat"),
    FOR("for"),
    BREAK("break"),
    CONTINUE("continue"),
    IF("if"),
    ELSE("else"),
    VAR("var"),
    CONST("const"),
    PROCEDURE("procedure"),
    FUNCTION("function"),
    RETURN("return"),
    WHENEVER("whenever"),
    HALT("halt"),
    ROBOT("robot"),
    END("end"),
    LEFT("left", beginsValue = true),
    RIGHT("right", beginsValue = true),
    DOWN("down", isFree = true),
    UP("up", isFree = true),
    TURNING("turning", isFree = true),
    FLOAT("float", isFree = true),
    SCREEN("screen", isFree = true),
    TIMES("times", isFree = true),
    FOREVER("forever"),
    WHILE("while"),
    UNTIL("until"),
    FROM("from"),
    TO("to"),
    STEP("step", isFree = true),
    EACH("each"),
    IN("in"),
    ON("on", isFree = true),
    FACING("facing", isFree = true),
    CM("cm"),
    DEGREES("degrees"),
    SECONDS("seconds"),
    MILLISECONDS("milliseconds"),
    BUMPER("bumper", isFree = true, endsValue = true),
    LIGHT("light", beginsValue = true, endsValue = true),
    SENSOR("sensor", beginsValue = true),
    BUTTON("button", beginsValue = true),
    RUN("run", isFree = true, endsValue = true),
    VIEW("view", isFree = true, endsValue = true),
    PRGM("prgm", isFree = true, endsValue = true),
    TIMER("timer", beginsValue = true, endsValue = true),
    BATTERY("battery", beginsValue = true, endsValue = true, needs = BrickFeature.BATTERY),
    TRUE("true", beginsValue = true, endsValue = true),
    FALSE("false", beginsValue = true, endsValue = true),
    AND("and"),
    OR("or"),
    NOT("not", beginsValue = true),
    MOD("mod"),
    BRICK("brick", isFree = true),
    RCX("rcx", isFree = true),
    NXT("nxt", isFree = true),
    SPIKE("spike", isFree = true),
    ESSENTIAL("essential", isFree = true),
    TECHNIC("technic", isFree = true),
    EV3("ev3", isFree = true),
    MICROBIT("microbit", isFree = true),
    SONAR("sonar", isFree = true, needs = BrickFeature.SONAR),
    SOUND("sound", isFree = true, needs = BrickFeature.SOUND_SENSOR),
    DISTANCE("distance", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.SONAR),
    COLOUR("colour", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    LOUDNESS("loudness", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.SOUND_SENSOR),
    TURNED("turned", beginsValue = true, yields = true, needs = BrickFeature.MOTOR_COUNTERS),
    BLACK("black", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    BLUE("blue", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    GREEN("green", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    YELLOW("yellow", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    RED("red", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    WHITE("white", beginsValue = true, endsValue = true, yields = true, needs = BrickFeature.COLOUR_SENSOR),
    ENTER("enter", isFree = true, endsValue = true, needs = BrickFeature.ENTER_BUTTON),
    ESCAPE("escape", isFree = true, endsValue = true, needs = BrickFeature.ESCAPE_BUTTON),
    ;

    fun isOn(brick: BrickKind): Boolean = needs == null || needs.isOn(brick)

    companion object {
        /** The words that a line can begin with. */
        val COMMANDS: Set<Keyword> = entries.filterTo(mutableSetOf()) { it <= END }
    }
}

/** Names, and keywords in sentences, ignore the case of A to Z. Platforms disagree about some other letters. */
internal fun lowercaseKeyword(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + CASE else it) } }

/** [word] in lower case, as far as spellings of keywords have capitals: from A to Z, and with the accents of Latin-1. */
internal fun lowercaseSpelling(word: String): String =
    buildString(word.length) { word.forEach { append(if (isCapital(it)) it + CASE else it) } }

/** The reverse of [lowercaseSpelling]. */
internal fun uppercaseSpelling(word: String): String =
    buildString(word.length) { word.forEach { append(if (isCapital(it - CASE)) it - CASE else it) } }

private fun isCapital(character: Char): Boolean =
    character in 'A'..'Z' || (character in '\u00C0'..'\u00DE' && character != '\u00D7')

/** The distance between a capital and its small letter. */
private const val CASE = 'a' - 'A'

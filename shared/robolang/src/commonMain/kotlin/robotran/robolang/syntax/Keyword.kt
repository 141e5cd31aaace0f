package robotran.robolang.syntax

/**
 * The keywords; they ignore case.
 *
 * @property text its spelling in Robolang.
 * @property singular another spelling, for one second or one degree.
 * @property isFree whether a pupil may use the word as a name, since it stands only where no name can.
 * @property endsValue whether it can end an expression, so that a minus after it subtracts.
 */
internal enum class Keyword(
    val text: String,
    val singular: String? = null,
    val isFree: Boolean = false,
    val endsValue: Boolean = false,
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
    LEFT("left"),
    RIGHT("right"),
    DOWN("down", isFree = true),
    UP("up", isFree = true),
    TURNING("turning", isFree = true),
    FLOAT("float", isFree = true),
    SCREEN("screen", isFree = true),
    TIMES("times", "time", isFree = true),
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
    DEGREES("degrees", "degree"),
    SECONDS("seconds", "second"),
    MILLISECONDS("milliseconds", "millisecond"),
    TRUE("true", endsValue = true),
    FALSE("false", endsValue = true),
    AND("and"),
    OR("or"),
    NOT("not"),
    MOD("mod"),
    BUMPER("bumper", isFree = true, endsValue = true),
    LIGHT("light", endsValue = true),
    SENSOR("sensor"),
    BUTTON("button"),
    RUN("run", isFree = true, endsValue = true),
    VIEW("view", isFree = true, endsValue = true),
    PRGM("prgm", isFree = true, endsValue = true),
    TIMER("timer", endsValue = true),
    BATTERY("battery", endsValue = true),
    ;

    companion object {
        /** The words that a line can begin with. */
        val COMMANDS: Set<Keyword> = entries.filterTo(mutableSetOf()) { it <= END }

        /** The keywords that begin a block. */
        val OPENERS: Set<Keyword> = setOf(REPEAT, FOR, IF, PROCEDURE, FUNCTION, WHENEVER, ROBOT)

        private val bySpelling: Map<String, Keyword> =
            entries.flatMap { keyword -> listOfNotNull(keyword.text, keyword.singular).map { it to keyword } }.toMap()

        private val longestSpelling: Int = bySpelling.keys.maxOf { it.length }

        /** The keyword [word], ignoring case. */
        fun of(word: String): Keyword? = if (word.length > longestSpelling) null else bySpelling[lowercaseKeyword(word)]
    }
}

/** Keywords are plain ASCII, as is their lower case: platforms disagree about some other letters. */
internal fun lowercaseKeyword(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + ('a' - 'A') else it) } }

package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.BuiltIn

/**
 * A method or field that a translation contains only if it is used. [JavaTemplates] has its Java.
 *
 * @property called its name.
 * @property isCalculation whether it is in the class [CALCULATION]: its many constants must not use up those of the
 * program's class, whose constant indices are bytes.
 * @property needs the helpers that it uses, which are declared above it.
 * @property brick the only brick that it is for; null for both.
 */
internal enum class JavaHelper(
    val called: String,
    val needs: List<JavaHelper> = emptyList(),
    val isField: Boolean = false,
    val isCalculation: Boolean = false,
    private val brick: BrickKind? = null,
) {
    CENTIMETRE("MILLISECONDS_PER_CENTIMETRE", isField = true),
    DEGREE("MILLISECONDS_PER_DEGREE", isField = true),
    PEN_TIME("PEN_MILLISECONDS", isField = true),
    PILOT_FIELD("pilot", isField = true, brick = BrickKind.NXT),
    DICE("dice", isField = true),
    TIMER_START("timerStart", isField = true),
    CONTROL("mainIsPaused", isField = true),
    GIVE_WAY("giveWay", listOf(CONTROL)),
    PAUSE("pause", listOf(GIVE_WAY)),
    PAUSE_IN_CONTROL("pauseInControl", listOf(GIVE_WAY)),
    ROUND_HALF_UP("roundHalfUp"),
    WAIT_SECONDS("waitSeconds", listOf(ROUND_HALF_UP)),
    WAIT_MILLISECONDS("waitMilliseconds", listOf(ROUND_HALF_UP)),
    PILOT("Pilot", brick = BrickKind.NXT),
    AWAIT_MOTOR("awaitMotor", listOf(GIVE_WAY), brick = BrickKind.NXT),
    TURN_MOTOR("turnMotor", listOf(AWAIT_MOTOR), brick = BrickKind.NXT),
    SPEED_OF("speedOf", brick = BrickKind.NXT),
    SHOW_TEXT("show", brick = BrickKind.NXT),
    SHOW_COLOUR("showColour", listOf(SHOW_TEXT), brick = BrickKind.NXT),
    DURATION_OF("durationOf", listOf(ROUND_HALF_UP)),
    STOP_AT("stopAt"),
    FORWARD_CENTIMETRES("forwardCentimetres", listOf(CENTIMETRE, DURATION_OF, STOP_AT)),
    BACKWARD_CENTIMETRES("backwardCentimetres", listOf(CENTIMETRE, DURATION_OF, STOP_AT)),
    FORWARD_SECONDS("forwardSeconds", listOf(DURATION_OF, STOP_AT)),
    BACKWARD_SECONDS("backwardSeconds", listOf(DURATION_OF, STOP_AT)),
    LEFT_DEGREES("turnLeftDegrees", listOf(DEGREE, DURATION_OF, STOP_AT)),
    RIGHT_DEGREES("turnRightDegrees", listOf(DEGREE, DURATION_OF, STOP_AT)),
    LEFT_SECONDS("turnLeftSeconds", listOf(DURATION_OF, STOP_AT)),
    RIGHT_SECONDS("turnRightSeconds", listOf(DURATION_OF, STOP_AT)),
    PEN_DOWN("penDown", listOf(PEN_TIME)),
    PEN_UP("penUp", listOf(PEN_TIME)),
    POWER_BOTH("power"),
    PLAY("play", listOf(ROUND_HALF_UP)),
    SHOW_WHOLE("show"),
    SHOW_DECIMAL("show", listOf(ROUND_HALF_UP)),
    TIMER("timer", listOf(TIMER_START)),
    RESET_TIMER("resetTimer", listOf(TIMER_START)),
    REMAINDER("remainder"),
    RANDOM("random", listOf(DICE)),
    RANDOM_DECIMAL("random", listOf(DICE)),
    FLOOR("floor"),
    CEIL("ceil"),
    ROUND("round", listOf(FLOOR)),
    SQRT("sqrt"),
    QUARTER_SINE("sineOfSmall", listOf(ROUND), isCalculation = true),
    SIN("sin", listOf(QUARTER_SINE), isCalculation = true),
    COS("cos", listOf(QUARTER_SINE), isCalculation = true),
    TAN("tan", listOf(SIN, COS), isCalculation = true),
    ATAN2("atan2", isCalculation = true),
    POW("pow", listOf(ROUND), isCalculation = true),
    ;

    /** The helpers that its Java for [robot] uses. */
    fun needsOn(robot: BrickKind, isReacting: Boolean): List<JavaHelper> =
        if (robot == BrickKind.RCX) needs else needsOnNxt(isReacting)

    private fun needsOnNxt(isReacting: Boolean): List<JavaHelper> = when (this) {
        PILOT_FIELD -> listOf(PILOT)
        PILOT -> if (isReacting) listOf(GIVE_WAY) else emptyList()
        STOP_AT -> listOf(PILOT_FIELD)
        PEN_DOWN, PEN_UP -> if (isReacting) listOf(AWAIT_MOTOR) else emptyList()
        SHOW_WHOLE -> listOf(SHOW_TEXT)
        SHOW_DECIMAL -> listOf(ROUND_HALF_UP, SHOW_TEXT)
        else -> needs
    }

    companion object {
        /** The class for helpers with many constants. */
        const val CALCULATION = "Calculation"

        /** Names that no variable of a program for [robot] may have. */
        fun fields(robot: BrickKind): Set<String> = namesOf(robot) { it.isField } + OTHER_FIELDS

        /** Names that no routine of a program for [robot] may have. */
        fun methods(robot: BrickKind): Set<String> = namesOf(robot) { !it.isField } + OTHER_METHODS

        private fun namesOf(robot: BrickKind, isMeant: (JavaHelper) -> Boolean): Set<String> =
            entries.filter { isMeant(it) && (it.brick == null || it.brick == robot) }.map { it.called }.toSet()

        private val OTHER_FIELDS =
            setOf("mainThread", "watchingThread", "mainIsPaused", "mainStandsStill", "actionIsSuppressed", "takenOver")

        private val OTHER_METHODS =
            setOf("cosineOfSmall", "arcOf", "smallArcOf", "wholePower", "logarithmToBase2", "powerOfTwo", "mustGiveWay")

        /** The helper for [builtIn]. */
        fun of(builtIn: BuiltIn): JavaHelper = entries.first { it.name == builtIn.name }
    }
}

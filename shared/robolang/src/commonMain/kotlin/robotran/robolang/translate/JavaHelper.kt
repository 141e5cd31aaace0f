package robotran.robolang.translate

import robotran.brick.kind.JavaPlatform
import robotran.robolang.syntax.BuiltIn

/**
 * A method or field that a translation contains only if it is used. [JavaTemplates] has its Java.
 *
 * @property called its name.
 * @property isCalculation whether it is in the class [CALCULATION]: its many constants must not use up those of the
 * program's class, whose constant indices are bytes.
 * @property needs the helpers that it uses, which are declared above it.
 * @property platform the only one that it is for; null for all.
 */
internal enum class JavaHelper(
    val called: String,
    val needs: List<JavaHelper> = emptyList(),
    val isField: Boolean = false,
    val isCalculation: Boolean = false,
    private val platform: JavaPlatform? = null,
) {
    CENTIMETRE("MILLISECONDS_PER_CENTIMETRE", isField = true),
    DEGREE("MILLISECONDS_PER_DEGREE", isField = true),
    PEN_TIME("PEN_MILLISECONDS", isField = true),
    PILOT_FIELD("pilot", isField = true, platform = JavaPlatform.NXJ),
    DICE("dice", isField = true),
    TIMER_START("timerStart", isField = true),
    CONTROL("mainIsPaused", isField = true),
    GIVE_WAY("giveWay", listOf(CONTROL)),
    PAUSE("pause", listOf(GIVE_WAY)),
    PAUSE_IN_CONTROL("pauseInControl", listOf(GIVE_WAY)),
    ROUND_HALF_UP("roundHalfUp"),
    WAIT_SECONDS("waitSeconds", listOf(ROUND_HALF_UP)),
    WAIT_MILLISECONDS("waitMilliseconds", listOf(ROUND_HALF_UP)),
    PILOT("Pilot", platform = JavaPlatform.NXJ),
    AWAIT_MOTOR("awaitMotor", listOf(GIVE_WAY), platform = JavaPlatform.NXJ),
    TURN_MOTOR("turnMotor", listOf(AWAIT_MOTOR), platform = JavaPlatform.NXJ),
    SPEED_OF("speedOf", platform = JavaPlatform.NXJ),
    SHOW_TEXT("show", platform = JavaPlatform.NXJ),
    SHOW_COLOUR("showColour", listOf(SHOW_TEXT), platform = JavaPlatform.NXJ),
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

    companion object {
        /** The class for helpers with many constants. */
        const val CALCULATION = "Calculation"

        /** Names that no variable of a program for [platform] may have. */
        fun fields(platform: JavaPlatform): Set<String> = namesOf(platform) { it.isField } + OTHER_FIELDS

        /** Names that no routine of a program for [platform] may have. */
        fun methods(platform: JavaPlatform): Set<String> = namesOf(platform) { !it.isField } + OTHER_METHODS

        private fun namesOf(platform: JavaPlatform, isMeant: (JavaHelper) -> Boolean): Set<String> =
            entries.filter { isMeant(it) && (it.platform == null || it.platform == platform) }.map { it.called }.toSet()

        private val OTHER_FIELDS =
            setOf("mainThread", "watchingThread", "mainIsPaused", "mainStandsStill", "actionIsSuppressed", "takenOver")

        private val OTHER_METHODS =
            setOf("cosineOfSmall", "arcOf", "smallArcOf", "wholePower", "logarithmToBase2", "powerOfTwo", "mustGiveWay")

        /** The helper for [builtIn]. */
        fun of(builtIn: BuiltIn): JavaHelper = entries.first { it.name == builtIn.name }
    }
}

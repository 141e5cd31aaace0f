package robotran.robolang.translate

import robotran.robolang.run.NxtConstants

/** The Java helpers for an NXT whose text differs from that for an RCX, or that only an NXT needs. */
internal object NxtTexts {
    /** The text of [helper]; null if it is the same for both bricks. */
    fun of(helper: JavaHelper, isReacting: Boolean): String? = when (helper) {
        JavaHelper.CONTROL -> JavaReactingTexts.CONTROL.replace(THRIFTY, THROWN)
        JavaHelper.PILOT -> NxtPilotTexts.pilot(isReacting)
        JavaHelper.STOP_AT -> if (isReacting) STOP_AT_REACTING else STOP_AT
        JavaHelper.FORWARD_SECONDS -> timed("Drives ahead for a while.", helper, "forward")
        JavaHelper.BACKWARD_SECONDS -> timed("Drives back for a while.", helper, "backward")
        JavaHelper.LEFT_SECONDS -> timed("Turns on the spot to the left for a while.", helper, "rotateLeft")
        JavaHelper.RIGHT_SECONDS -> timed("Turns on the spot to the right for a while.", helper, "rotateRight")
        JavaHelper.PEN_DOWN -> pen("Lowers the pen.", helper, NxtConstants.PEN_DEGREES, isReacting)
        JavaHelper.PEN_UP -> pen("Lifts the pen.", helper, 0, isReacting)
        JavaHelper.TURN_MOTOR -> TURN_MOTOR
        JavaHelper.AWAIT_MOTOR -> AWAIT_MOTOR
        JavaHelper.SPEED_OF -> SPEED_OF
        JavaHelper.PLAY -> PLAY.replace("Thread.sleep(", if (isReacting) "pause(" else "Thread.sleep(")
        JavaHelper.SHOW_TEXT -> SHOW_TEXT
        JavaHelper.SHOW_WHOLE -> SHOW_WHOLE
        JavaHelper.SHOW_DECIMAL -> SHOW_DECIMAL
        JavaHelper.SHOW_COLOUR -> SHOW_COLOUR
        JavaHelper.REMAINDER -> REMAINDER
        else -> null
    }

    /** What the text of [helper] for an NXT uses; null if that is the same for both bricks. */
    fun needsOf(helper: JavaHelper, isReacting: Boolean): List<JavaHelper>? = when (helper) {
        JavaHelper.STOP_AT -> listOf(JavaHelper.PILOT_FIELD)
        JavaHelper.PEN_DOWN, JavaHelper.PEN_UP -> if (isReacting) listOf(JavaHelper.AWAIT_MOTOR) else emptyList()
        JavaHelper.SHOW_WHOLE -> listOf(JavaHelper.SHOW_TEXT)
        JavaHelper.SHOW_DECIMAL -> listOf(JavaHelper.ROUND_HALF_UP, JavaHelper.SHOW_TEXT)
        else -> null
    }

    /** An NXT collects what is no longer needed. */
    private const val THRIFTY = "Thrown again and again, for the brick never takes back the memory of a new one."
    private const val THROWN = "Thrown where a behaviour takes over."

    private fun timed(sentence: String, helper: JavaHelper, start: String) = """/** $sentence */
static void ${helper.called}(float seconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + durationOf(seconds * 1000);
    pilot.$start();
    stopAt(end);
}"""

    private const val STOP_AT = """/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    int left = time - (int) System.currentTimeMillis();
    if (left > 0) Thread.sleep(left);
    pilot.stop();
}"""

    private const val STOP_AT_REACTING =
        """/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    pauseInControl(time);
    pilot.stop();
}"""

    /** `PEN` is replaced by the motor of the robot. */
    private fun pen(sentence: String, helper: JavaHelper, degrees: Int, isReacting: Boolean): String = if (isReacting) {
        """/** $sentence */
static void ${helper.called}() throws InterruptedException {
    PEN.rotateTo($degrees, true);
    awaitMotor(PEN);
}"""
    } else {
        """/** $sentence */
static void ${helper.called}() {
    PEN.rotateTo($degrees);
}"""
    }

    private const val TURN_MOTOR = """/** Turns a motor by so many degrees, but only until a behaviour takes over. */
static void turnMotor(NXTRegulatedMotor motor, int angle) throws InterruptedException {
    motor.rotate(angle, true);
    awaitMotor(motor);
}"""

    private const val AWAIT_MOTOR = """/** Waits until a motor stands, but only until a behaviour takes over. */
static void awaitMotor(NXTRegulatedMotor motor) throws InterruptedException {
    while (motor.isMoving() && !mustGiveWay()) Thread.sleep(1);
    if (motor.isMoving()) motor.stop(true);
    giveWay();
}"""

    private const val SPEED_OF = """/** How many degrees a motor of this power, 0 to 7, turns in a second. */
static int speedOf(int power) {
    return power == 0 ? ${NxtConstants.SLOWEST_SPEED} : power * ${NxtConstants.SPEED_OF_POWER};
}"""

    private const val PLAY = """/** Plays a tone to its end. */
static void play(int frequency, float seconds) throws InterruptedException {
    int milliseconds = roundHalfUp(seconds * 100) * 10;
    if (milliseconds == 0) return;
    Sound.playTone(frequency, milliseconds);
    Thread.sleep(milliseconds);
}"""

    private const val SHOW_TEXT = """/** Shows a text in the first row. */
static void show(String text) {
    LCD.clear(0);
    LCD.drawString(text, 0, 0);
}"""

    private const val SHOW_WHOLE = """/** Shows a whole number with its sign. */
static void show(int number) {
    show(String.valueOf(number));
}"""

    private const val SHOW_DECIMAL = """/** Shows a number with at most three digits behind its point. */
static void show(float number) {
    float magnitude = number < 0 ? -number : number;
    int decimals = 3;
    int digits = roundHalfUp(magnitude * 10 * 10 * 10);
    while (digits > 9999999 && decimals > 0) {
        decimals--;
        float scaled = magnitude;
        for (int place = 0; place < decimals; place++) scaled *= 10;
        digits = roundHalfUp(scaled);
    }
    int whole = digits;
    int unit = 1;
    for (int place = 0; place < decimals; place++) unit *= 10;
    while (decimals > 1 && whole % 10 == 0) {
        decimals--;
        whole /= 10;
        unit /= 10;
    }
    String text = String.valueOf(whole / unit);
    if (decimals > 0) text += "." + String.valueOf(unit + whole % unit).substring(1);
    show(number < 0 ? "-" + text : text);
}"""

    private const val SHOW_COLOUR = """/** Shows the name of a colour. */
static void showColour(int colour) {
    String[] names = {"RED", "GREEN", "BLUE", "YELLOW", "NONE", "NONE", "WHITE", "BLACK"};
    show(colour >= 0 && colour < names.length ? names[colour] : "NONE");
}"""

    private const val REMAINDER = """/** What is left of a division without a fraction. */
static float remainder(float left, float right) {
    return left - right * (int) (left / right);
}"""
}

package robotran.robolang.translate

import robotran.brick.kind.JavaPlatform

/** The words that cannot be names in Java. */
internal object JavaWords {
    private val LANGUAGE =
        words(
            "abstract assert boolean break byte case catch char class const continue default do double else enum " +
                "extends false final",
            "finally float for goto if implements import instanceof int interface long native new null package " +
                "private protected public",
            "return short static strictfp super switch synchronized this throw throws transient true try void " +
                "volatile while _",
        )

    private val CLASSES =
        words(
            "Motor Sensor SensorConstants Button LCD LCDConstants TextLCD MinLCD Segment Sound MinSound Battery ROM " +
                "Memory Poll Serial",
            "Servo Message Opcode Behavior Arbitrator Math Thread System String StringBuffer Object Integer Float " +
                "Throwable Exception",
            "InterruptedException Random Runtime Class Error Vector Stack Queue Hashtable BitSet Calculation",
        )

    /** The methods of Object, and `main`. */
    private val METHODS = words("main toString equals hashCode getClass wait notify notifyAll clone finalize")

    /** The class names of the translation itself, and file names forbidden on Windows. */
    private val FILES = words("MainProgram Reactions Con Prn Aux Nul")

    private val NXJ_CLASSES =
        words(
            "Motor MotorPort NXTRegulatedMotor NXTMotor SensorPort TouchSensor LightSensor UltrasonicSensor " +
                "ColorSensor SoundSensor Color",
            "Button LCD Sound Battery NXT Math Thread System String StringBuffer StringBuilder Object Integer Float " +
                "Throwable Exception Behavior",
            "InterruptedException Random Runtime Class Error Enum Iterable Override Calculation Pilot Actions",
        )

    private val LEJOS_VARIABLES = LANGUAGE + CLASSES + JavaHelper.fields(JavaPlatform.LEJOS) +
        words("arguments josx java")
    private val LEJOS_METHODS = LANGUAGE + CLASSES + METHODS + JavaHelper.methods(JavaPlatform.LEJOS)
    private val NXJ_VARIABLES = LANGUAGE + NXJ_CLASSES + JavaHelper.fields(JavaPlatform.NXJ) + NxtSensorFields.ALL +
        words("arguments lejos java WHEEL_DIAMETER TRACK_WIDTH")
    private val NXJ_METHODS = LANGUAGE + NXJ_CLASSES + METHODS + JavaHelper.methods(JavaPlatform.NXJ)

    val NO_CLASSES: Set<String> = LANGUAGE + CLASSES + NXJ_CLASSES + FILES

    fun noVariables(platform: JavaPlatform): Set<String> = when (platform) {
        JavaPlatform.LEJOS -> LEJOS_VARIABLES
        JavaPlatform.NXJ -> NXJ_VARIABLES
    }

    fun noMethods(platform: JavaPlatform): Set<String> = when (platform) {
        JavaPlatform.LEJOS -> LEJOS_METHODS
        JavaPlatform.NXJ -> NXJ_METHODS
    }

    private fun words(vararg lines: String): Set<String> = lines.flatMap { it.split(' ') }.toSet()
}

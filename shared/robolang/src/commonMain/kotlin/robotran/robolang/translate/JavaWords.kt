package robotran.robolang.translate

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

    val NO_VARIABLES: Set<String> = LANGUAGE + CLASSES + JavaHelper.FIELDS + words("arguments josx java")
    val NO_METHODS: Set<String> = LANGUAGE + CLASSES + METHODS + JavaHelper.METHODS
    val NO_CLASSES: Set<String> = LANGUAGE + CLASSES + FILES

    private fun words(vararg lines: String): Set<String> = lines.flatMap { it.split(' ') }.toSet()
}

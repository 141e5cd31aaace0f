package robotran.robolang.translate

/** The words that no name of a program may be in Java. */
internal object JavaWords {
    private val LANGUAGE =
        words(
            "abstract assert boolean break byte case catch char class const continue default do double else enum extends false final",
            "finally float for goto if implements import instanceof int interface long native new null package private protected public",
            "return short static strictfp super switch synchronized this throw throws transient true try void volatile while _",
        )

    private val CLASSES =
        words(
            "Motor Sensor SensorConstants Button LCD LCDConstants TextLCD MinLCD Segment Sound MinSound Battery ROM Memory Poll Serial",
            "Servo Message Opcode Behavior Arbitrator Math Thread System String StringBuffer Object Integer Float Throwable Exception",
            "InterruptedException Random Runtime Class Error Vector Stack Queue Hashtable BitSet",
        )

    /** What every class has from Object, and what the translation itself calls things. */
    private val OWN = words("main arguments toString equals hashCode getClass wait notify notifyAll clone finalize josx java")

    val RESERVED: Set<String> = LANGUAGE + CLASSES + OWN + JavaHelper.NAMES

    private fun words(vararg lines: String): Set<String> = lines.flatMap { it.split(' ') }.toSet()
}

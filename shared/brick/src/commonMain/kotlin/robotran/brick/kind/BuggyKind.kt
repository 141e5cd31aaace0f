package robotran.brick.kind

/**
 * The buggies that a micro:bit is plugged into. What each needs to drive is data of `shared/microbit`.
 *
 * @property label what people call it.
 */
enum class BuggyKind(val label: String) {
    /** ELECFREAKS Smart Cutebot. */
    CUTEBOT("Cutebot"),

    /** ELECFREAKS Cutebot Pro, second generation. */
    CUTEBOT_PRO("Cutebot Pro"),

    /** DFRobot micro:Maqueen Lite. */
    MAQUEEN("Maqueen"),

    /** DFRobot micro:Maqueen Plus V2. */
    MAQUEEN_PLUS("Maqueen Plus"),

    /** Yahboom Tiny:bit. */
    TINY_BIT("Tiny:bit"),

    /** Kitronik :MOVE Motor, boards V1 and V2. */
    KITRONIK_MOVE("Kitronik :MOVE Motor"),

    /** Any other with two motors, whose pins the pupil names. */
    PLAIN("micro:bit buggy"),
    ;

    /** What it is called in files and on the command line. */
    val word: String get() = name.lowercase().replace('_', '-')

    companion object {
        /** The buggy that [word] names; null if there is none. */
        fun of(word: String): BuggyKind? = entries.firstOrNull { it.word == word }
    }
}

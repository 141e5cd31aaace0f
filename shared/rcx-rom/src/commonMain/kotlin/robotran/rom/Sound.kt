package robotran.rom

/** What takes one place in the loudspeaker's queue: notes played one after the other. */
internal typealias Sound = List<Note>

/**
 * A tone or a pause.
 *
 * @property hertz null for a pause.
 */
internal data class Note(
    val hertz: Double?,
    val durationMilliseconds: Int,
)

/** The sounds the ROM knows by number. Source of pitches and lengths: the tables of brickEmu's re-implemented ROM. */
internal object SystemSounds {
    const val BEEP = 0
    const val TWO_BEEPS = 1
    const val DOWN = 2
    const val UP = 3
    const val BUZZ = 4
    const val FAST_UP = 5

    private val melodyDown =
        listOf(179, 192, 208, 227, 250).map { frequency(DIVISOR_32, it) } +
            listOf(139, 156, 179, 208, 250).map { frequency(DIVISOR_64, it) }

    private val sounds: List<Sound> = listOf(
        listOf(Note(frequency(DIVISOR_32, counts = 125), 10), Note(null, 30)),
        List(2) { listOf(Note(frequency(DIVISOR_32, counts = 250), 150), Note(null, 50)) }.flatten(),
        melodyDown.map { Note(it, 60) },
        melodyDown.reversed().map { Note(it, 60) },
        listOf(Note(frequency(DIVISOR_1024, counts = 78), 1_000)),
        melodyDown.reversed().map { Note(it, 30) },
    )

    private val names = listOf("beep", "two beeps", "melody down", "melody up", "buzz", "fast melody up")

    /** The sound that is really played for [number]. */
    fun played(number: Int): Int = if (number in sounds.indices) number else BUZZ

    fun sound(number: Int): Sound = sounds[played(number)]

    fun name(number: Int): String = names[played(number)]

    private const val DIVISOR_32 = 32
    private const val DIVISOR_64 = 64
    private const val DIVISOR_1024 = 1024

    private fun frequency(divisor: Int, counts: Int): Double = ToneTimer.CLOCK_HERTZ.toDouble() / divisor / counts
}

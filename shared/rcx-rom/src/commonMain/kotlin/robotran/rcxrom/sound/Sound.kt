package robotran.rcxrom.sound

/**
 * An entry of the ROM's sound queue, as routine 0x3de0 takes it.
 *
 * @property kind 0 a pause, 1 a system sound, otherwise a tone: the timer counts for half a wave, 2..255.
 * @property value the duration of a pause or tone in [Speaker.LOOK_MILLISECONDS], or the number of a system sound;
 * 0..255.
 * @property control selects the divided clock that the timer counts, see [ToneTimer].
 */
internal data class Sound(val kind: Int, val value: Int, val control: Int) {
    companion object {
        const val PAUSE = 0
        const val SYSTEM_SOUND = 1

        fun system(number: Int) = Sound(SYSTEM_SOUND, SystemSounds.played(number), ToneTimer.CONTROL_OF_PAUSE)
    }
}

/**
 * A tone or a pause.
 *
 * @property hertz null for a pause.
 * @property duration in [Speaker.LOOK_MILLISECONDS], 0..255.
 */
internal data class Note(val hertz: Double?, val duration: Int)

/** The ROM's numbered sounds. Source of pitches and lengths: the tables of brickEmu's ROM re-implementation. */
internal object SystemSounds {
    const val BEEP = 0
    const val TWO_BEEPS = 1
    const val DOWN = 2
    const val UP = 3
    const val BUZZ = 4

    private val melodyDown =
        listOf(179, 192, 208, 227, 250).map { ToneTimer.hertz(it, ToneTimer.CONTROL_OF_32) } +
            listOf(139, 156, 179, 208, 250).map { ToneTimer.hertz(it, ToneTimer.CONTROL_OF_64) }

    private val sounds: List<List<Note>> = listOf(
        listOf(Note(ToneTimer.hertz(counts = 125, ToneTimer.CONTROL_OF_32), 1), Note(null, 3)),
        List(2) { listOf(Note(ToneTimer.hertz(counts = 250, ToneTimer.CONTROL_OF_32), 15), Note(null, 5)) }.flatten(),
        melodyDown.map { Note(it, 6) },
        melodyDown.reversed().map { Note(it, 6) },
        listOf(Note(ToneTimer.hertz(counts = 78, ToneTimer.CONTROL_OF_1024), 100)),
        melodyDown.reversed().map { Note(it, 3) },
    )

    /** The sound that [number] really plays. */
    fun played(number: Int): Int = if (number in sounds.indices) number else BUZZ

    fun notes(number: Int): List<Note> = sounds[played(number)]
}

package robotran.blockediting.palette

/**
 * A note for `play`.
 *
 * @property name its name as in English, with the number of the octave.
 * @property frequency in hertz, the nearest whole number to equal temperament with A4 = 440 Hz.
 */
data class MusicalNote(val name: String, val frequency: Int)

/** The white keys of two octaves, those that a pupil's melody needs first. */
val MUSICAL_NOTES: List<MusicalNote> = listOf(
    MusicalNote("C4", 262),
    MusicalNote("D4", 294),
    MusicalNote("E4", 330),
    MusicalNote("F4", 349),
    MusicalNote("G4", 392),
    MusicalNote("A4", 440),
    MusicalNote("B4", 494),
    MusicalNote("C5", 523),
    MusicalNote("D5", 587),
    MusicalNote("E5", 659),
    MusicalNote("F5", 698),
    MusicalNote("G5", 784),
    MusicalNote("A5", 880),
    MusicalNote("B5", 988),
    MusicalNote("C6", 1047),
)

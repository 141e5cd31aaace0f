package robotran.workshop

/** The program text that the pupil sees. */
internal val Workshop.text: String get() = state.programText

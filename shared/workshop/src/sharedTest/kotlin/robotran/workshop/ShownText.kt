package robotran.workshop

internal val Workshop.text: String get() = state.programText

package robotran.ui.workshop

/** The parts of the screen; a phone shows one at a time. */
enum class Pane { PROGRAM, WORLD, BRICK }

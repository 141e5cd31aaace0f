package robotran.workshop.state

/** The parts of the screen; a phone shows one at a time. */
enum class Pane { PROGRAM, WORLD, BRICK }

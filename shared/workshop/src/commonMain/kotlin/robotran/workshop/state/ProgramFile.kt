package robotran.workshop.state

/**
 * A program as it lies in a file.
 *
 * @property name the file's name without its folders; the brick calls the program by it.
 * @property text what is written in it, with any line ends.
 */
data class ProgramFile(val name: String, val text: String)

package robotran.workshop.state

/**
 * A program file.
 *
 * @property name the file name without folders, which the brick shows as the program's name.
 * @property text the content, with any line ends.
 */
data class ProgramFile(val name: String, val text: String)

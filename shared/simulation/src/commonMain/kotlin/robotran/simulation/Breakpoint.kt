package robotran.simulation

/**
 * A line that a program is to stop before.
 *
 * @property line from 1.
 * @property sourceFile the file that the line is in; null for this line of any file. A program of one file stops
 * whatever this says.
 */
data class Breakpoint(val line: Int, val sourceFile: String? = null)

package robotran.brick.state

/** What the display of a brick shows; immutable, and equal to another that shows the same. */
interface Screen {
    /** Its rows from top to bottom in plain text, without blanks at their ends; a display of one row has one. */
    val lines: List<String>

    /** All of it in plain text: its [lines], without blanks around them. */
    val text: String get() = lines.joinToString("\n").trim()

    /** The parts that a program may have shown as one text, in plain text and without blanks around them; may repeat. */
    val texts: List<String>

    /** Whether it shows [text], which a program has shown as a number or as text. Ignores blanks around it. */
    fun shows(text: String): Boolean
}

package robotran.brick.messages

import robotran.brick.program.ProgramFailure
import robotran.brick.program.RuntimeWarning

/** The location of the failure in words, such as `Line 7` or `Robot.java, line 7`; null if there is no line. */
fun ProgramFailure.place(messages: PlaceMessages): String? = locationText(sourceLine, sourceFile, messages)

/** The location of the warning in words, like [ProgramFailure.place]. */
fun RuntimeWarning.place(messages: PlaceMessages): String? = locationText(sourceLine, sourceFile, messages)

private fun locationText(line: Int, file: String?, messages: PlaceMessages): String? = if (line == 0) {
    null
} else {
    messages.place(line, file)
}

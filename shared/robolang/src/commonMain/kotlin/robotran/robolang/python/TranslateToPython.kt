package robotran.robolang.python

import robotran.robolang.RobolangProgram
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.pybricks.PybricksTarget
import robotran.robolang.robot.RobotTarget

/**
 * Translates [program] to Python for a [robot] whose hub runs Pybricks, as a teacher would write it: the devices of the
 * robot at the top, then the functions, then the main program, with what Robolang's commands mean there and no more.
 * Never throws.
 *
 * @param messages the notes in the pupil's language.
 */
fun translateToPython(
    program: RobolangProgram,
    robot: RobotTarget.Hub,
    messages: PythonTranslationMessages,
): PythonTranslation = translateToPython(program, messages) { PybricksTarget(robot, it) }

private fun translateToPython(
    program: RobolangProgram,
    messages: PythonTranslationMessages,
    targetOf: (PythonContext) -> PythonTarget,
): PythonTranslation {
    // Written once to know the names that the translation itself uses, which the pupil's then must not have.
    val taken = PythonFile(program, targetOf, PythonNotes(messages), emptySet()).apply { write() }.names
    val notes = PythonNotes(messages)
    val writer = PythonFile(program, targetOf, notes, taken).write()
    return PythonTranslation(fileNameOf(program.name), writer.text, writer.lineMap, notes.inOrder())
}

private fun fileNameOf(program: String): String =
    program.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".robo").ifEmpty { "program" } + ".py"

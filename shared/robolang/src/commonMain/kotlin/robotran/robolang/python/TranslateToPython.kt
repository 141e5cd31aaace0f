package robotran.robolang.python

import robotran.robolang.RobolangProgram
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.microbit.BoardRoom
import robotran.robolang.python.microbit.MicrobitTarget
import robotran.robolang.python.microbit.noteOfSize
import robotran.robolang.python.pybricks.PybricksTarget
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonFile
import robotran.robolang.python.writer.PythonNotes
import robotran.robolang.python.writer.PythonTarget
import robotran.robolang.python.writer.WrittenNote
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.allStatements

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

/**
 * Translates [program] to MicroPython for a [robot] with a micro:bit: the numbers of this robot at the top, then functions
 * for what the program does with it, then the main program, which stops the wheels however it ends. Old enough for
 * MicroPython 1.9.2, which a V1 has. Never throws.
 *
 * @param messages the notes in the pupil's language.
 */
fun translateToPython(
    program: RobolangProgram,
    robot: RobotTarget.Microbit,
    messages: PythonTranslationMessages,
): PythonTranslation = translateToPython(program, messages) { MicrobitTarget(robot, it) }.let {
    val statements = allStatements(program.checked.tree)
    val room = BoardRoom.of(robot.model, it.python)
    val size = noteOfSize(robot.model, statements, room, messages)?.toNote()
    val notes = (it.notes + listOfNotNull(size)).sortedBy { note -> note.range.line }
    PythonTranslation(it.fileName, it.python, it.lineMap, notes, room)
}

/** Translates [program] for the robot that it was compiled for; null if that runs no Python. Never throws. */
fun pythonOf(program: RobolangProgram, messages: PythonTranslationMessages): PythonTranslation? =
    when (val robot = program.robot) {
        is RobotTarget.Hub -> translateToPython(program, robot, messages)
        is RobotTarget.Microbit -> translateToPython(program, robot, messages)
        is RobotTarget.Rcx, is RobotTarget.Nxt -> null
    }

private fun translateToPython(
    program: RobolangProgram,
    messages: PythonTranslationMessages,
    targetOf: (PythonContext) -> PythonTarget,
): PythonTranslation {
    // Written once to know the names that the translation itself uses, which the pupil's then must not have.
    val taken = PythonFile(program, targetOf, PythonNotes(messages), emptySet()).apply { write() }.names
    val notes = PythonNotes(messages)
    val writer = PythonFile(program, targetOf, notes, taken).write()
    val all = notes.inOrder().map { it.toNote() }
    return PythonTranslation(fileNameOf(program.name), writer.text, writer.lineMap, all)
}

private fun WrittenNote.toNote() = PythonNote(range, message, isLost)

private fun fileNameOf(program: String): String =
    program.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".robo").ifEmpty { "program" } + ".py"

package robotran.robolang.python.microbit

import robotran.language.Language
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.MicroPython
import robotran.robolang.python.translateToPython
import kotlin.test.assertEquals

/**
 * Runs the translations of [texts] for the robot [robotName] on the fake modules, and fails if one does not what the
 * interpreter does, but for those named in [known]; returns how many ran.
 */
internal fun runOnBuggy(robotName: String, texts: Map<String, String>, known: Set<String>): Int {
    val robot = allBuggies.getValue(robotName)
    val programs = texts.mapNotNull { (name, text) -> programForBoard(text, name, robot)?.let { name to it } }.toMap()
    val messages = PythonTranslationMessages.of(Language.ENGLISH)
    val translations = programs.mapValues { (_, it) -> translateToPython(it, robot, messages) }
        .filterValues { it.isComplete }
    val pins = fakePinsOf(robot.buggy)
    val logs = MicroPython.run(translations.mapValues { "$pins\n${it.value.python}" }, MicroPython.BOARD)
    val all = translations.map { (name, it) ->
        compareOnBoard(name, programs.getValue(name), it.python, logs.getValue(name))
    }
    assertEquals(emptyList(), all.filter { it.isWrong && it.name !in known }.map { "$robotName $it" }, robotName)
    return all.size
}

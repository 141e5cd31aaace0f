package robotran.console

import robotran.console.messages.ConsoleMessages
import robotran.language.Language

/** Tells in one sentence, without a stack trace, that Robotran itself has a mistake, which [problem] shows. */
fun Console.tellUnexpected(problem: Throwable, language: Language) =
    visible().complain(ConsoleMessages.of(language).unexpected(summaryOf(problem)))

/** The same for whatever a thread of this process does not catch. [arguments] of the process name the language. */
fun tellUncaught(arguments: List<String>) = Thread.setDefaultUncaughtExceptionHandler { _, problem ->
    ProcessConsole.tellUnexpected(problem, languageIn(arguments))
}

/** In one line: what [problem] is, and the first of our functions that it met. */
private fun summaryOf(problem: Throwable): String {
    val first = generateSequence(problem) { it.cause }.take(DEEPEST).last()
    val place = first.stackTrace.run { firstOrNull { it.className.startsWith("robotran.") } ?: firstOrNull() }
    val what = listOfNotNull(first::class.simpleName, first.message?.lineSequence()?.first()?.take(LONGEST))
    return what.joinToString(": ") + place?.let { " (${it.fileName}:${it.lineNumber})" }.orEmpty()
}

private const val DEEPEST = 10
private const val LONGEST = 200

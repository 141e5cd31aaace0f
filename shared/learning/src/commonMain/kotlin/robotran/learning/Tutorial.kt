package robotran.learning

import robotran.language.Language
import robotran.programs.SourceFile
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * The tutorial: the folders of `learning/tutorial` in the order of their names. A folder has a text in each language,
 * `text.en.md` and so on, the world `world.world.json`, the program to try, and `solution` with the same ending.
 */
object Tutorial {
    /** The steps in their order. */
    val steps: List<TutorialStep> by lazy {
        tutorialTexts.entries.groupBy({ it.key.substringBefore('/') }) { it.key.substringAfter('/') to it.value }
            .toList().sortedBy { it.first }.map { (name, files) -> stepOf(name, files.toMap()) }
    }

    /** The step whose world [world] is, in whatever language; null if it is none of theirs. */
    fun stepIn(world: World): TutorialStep? = steps.firstOrNull { it.world(Language.ENGLISH).isSamePlaceAs(world) }

    private fun stepOf(name: String, files: Map<String, String>): TutorialStep {
        val programs = files.filterKeys { it.endsWith(ROBOLANG_FILE) || it.endsWith(JAVA_FILE) }
        val program = programs.entries.single { !it.key.startsWith(SOLUTION) }
        return TutorialStep(
            name,
            SourceFile(program.key, program.value),
            SourceFile(program.key, programs.entries.single { it.key.startsWith(SOLUTION) }.value),
            worldOf(files.getValue("world.world.json")),
            Language.entries.associateWith { textOf(files.getValue("text.${it.tag}.md")) },
        )
    }

    private fun textOf(file: String): TutorialText {
        val whole = sections(file).single()
        val parts = sections(whole.body, "## ").associate { it.heading to paragraphs(it.body) }
        val before = whole.body.substringBefore("## ")
        val task = parts.getValue("Task").joinToString(" ")
        val hint = parts.getValue("Hint").joinToString(" ")
        return TutorialText(whole.heading, paragraphs(before), task, hint)
    }

    private const val SOLUTION = "solution."
    private const val ROBOLANG_FILE = ".robo"
}

/** A world that comes with the app, so that it cannot be refused. */
internal fun worldOf(text: String): World = when (val result = readWorld(text)) {
    is WorldFileResult.Loaded -> result.world
    is WorldFileResult.Rejected -> error(result.message)
}

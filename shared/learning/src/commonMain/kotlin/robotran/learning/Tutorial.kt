package robotran.learning

import robotran.language.Language
import robotran.programs.SourceFile
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * The tutorial. Each folder in `learning/tutorial` is a step, in the order of their names. It holds a text for each
 * language, such as `text.en.md`, the world `world.world.json`, the program, and `solution` with the program's
 * extension.
 */
object Tutorial {
    val steps: List<TutorialStep> by lazy {
        tutorialTexts.entries.groupBy({ it.key.substringBefore('/') }) { it.key.substringAfter('/') to it.value }
            .toList().sortedBy { it.first }.map { (name, files) -> stepOf(name, files.toMap()) }
    }

    /** The step whose world is [world], in any language; null if there is none. */
    fun stepIn(world: World): TutorialStep? = steps.firstOrNull { it.world(Language.ENGLISH).isSameWorldAs(world) }

    private fun stepOf(name: String, files: Map<String, String>): TutorialStep {
        val programs = files.filterKeys { it.endsWith(ROBOLANG_FILE) || it.endsWith(JAVA_FILE) }
        val program = programs.entries.single { !it.key.startsWith(SOLUTION) }
        return TutorialStep(
            name,
            SourceFile(program.key, program.value),
            SourceFile(program.key, programs.entries.single { it.key.startsWith(SOLUTION) }.value),
            worldOf(files.getValue("world.world.json")),
            Language.entries.associateWith { files.getValue("text.${it.tag}.md") },
        )
    }

    private const val SOLUTION = "solution."
    private const val ROBOLANG_FILE = ".robo"
}

/** Reads a world that comes with the app. Fails if the file is invalid. */
internal fun worldOf(text: String): World = when (val result = readWorld(text)) {
    is WorldFileResult.Loaded -> result.world
    is WorldFileResult.Rejected -> error(result.message)
}

package robotran.learning

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * The lessons. Each folder in `learning/lessons` is a strand, each folder in it a lesson, in the order of their names.
 * A lesson holds a text for each language, such as `text.en.md`, the world `world.world.json`, the program, and
 * `solution` with the program's extension. Its robot has an RCX. The same lesson with an NXT has the NXT penbot; see
 * [versionForNxt].
 */
object Lessons {
    /** The strands, in the order in which a pupil takes them. */
    val strands: List<Strand> by lazy {
        val lessons = lessonTexts.entries.groupBy({ it.key.substringBeforeLast('/') }) {
            it.key.substringAfterLast('/') to it.value
        }.toList().sortedBy { it.first }.map { (folder, files) -> lessonOf(folder, files.toMap()) }
        strandNames().mapNotNull { name ->
            lessons.filter { it.strand == name }.takeIf { it.isNotEmpty() }?.let { Strand(name, it) }
        }
    }

    /** The lessons of all strands, one after the other. */
    val all: List<Lesson> by lazy { strands.flatMap { it.lessons } }

    /** The lesson, on one of its bricks, whose world is [world], in any language; null if there is none. */
    fun lessonIn(world: World): Lesson? = all.firstNotNullOfOrNull { it.foundIn(world) }

    /** The lesson called [name], also by its name of an older version, such as `03-repeat`; null if there is none. */
    fun named(name: String): Lesson? = name.replace(NUMBER, "").let { plain -> all.firstOrNull { it.name == plain } }

    /** The index in [all] of [lesson], on whichever brick; -1 if it is none of them. */
    fun indexOf(lesson: Lesson): Int = all.indexOfFirst { it.name == lesson.name }

    /** The strand that [lesson] is in. */
    fun strandOf(lesson: Lesson): Strand = strands.first { it.name == lesson.strand }

    private fun lessonOf(folder: String, files: Map<String, String>): Lesson {
        val rcx = versionForRcx(files)
        val nxt = versionForNxt(rcx, files)
        return lesson(folder, rcx, files) { lesson(folder, nxt, files, null) }
    }

    private fun lesson(
        folder: String,
        version: LessonVersion,
        files: Map<String, String>,
        forNxt: (() -> Lesson)?,
    ): Lesson = Lesson(
        folder.substringAfter('/').replace(NUMBER, ""),
        folder.substringBefore('/'),
        version.program,
        version.solution,
        otherSolutions = emptyList(),
        version.world,
        forNxt,
    ) { language, inBlocks -> LessonText.of(files.getValue("text.${language.tag}.md"), inBlocks, version.brick) }

    private val NUMBER = Regex("^[0-9]+-")
}

internal fun isProgram(file: String): Boolean = ProgramLanguage.ofFile(file) != null

/** How the file of a solution is called, apart from its extension. */
internal const val SOLUTION = "solution."

/** Reads a world that comes with the app. Fails if the file is invalid. */
internal fun worldOf(text: String): World = when (val result = readWorld(text)) {
    is WorldFileResult.Loaded -> result.world
    is WorldFileResult.Rejected -> error(result.message)
}

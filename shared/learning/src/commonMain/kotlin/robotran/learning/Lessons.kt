package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * The lessons. Each folder in `learning/lessons` is a strand, each folder in it a lesson, in the order of their names.
 * A lesson holds a text for each language, such as `text.en.md`, the world `world.world.json`, the program, and
 * `solution` with the program's extension. Its robot has the [BrickKind.default]. The same lesson with another brick has the penbot
 * of that; see [versionFor]. A lesson whose world names a robot with another brick is about that one, and there for it alone.
 */
object Lessons {
    /** The strands, in the order in which a pupil takes them. */
    val strands: List<Strand> by lazy {
        val lessons = folders().map { (folder, files) -> lessonOf(folder, files) }
        strandNames().mapNotNull { name ->
            lessons.filter { it.strand == name }.takeIf { it.isNotEmpty() }?.let { Strand(name, it) }
        }
    }

    /** The lessons of all strands, one after the other. */
    val all: List<Lesson> by lazy { strands.flatMap { it.lessons } }

    /** The lesson, on one of its bricks, whose world is [world], in any language; null if there is none. */
    fun lessonIn(world: World): Lesson? =
        if (world.goals.isEmpty()) null else all.firstNotNullOfOrNull { it.foundIn(world) }

    /** The lesson called [name], also by its name of an older version, such as `03-repeat`; null if there is none. */
    fun named(name: String): Lesson? = name.replace(NUMBER, "").let { plain -> all.firstOrNull { it.name == plain } }

    /** The index in [all] of [lesson], on whichever brick; -1 if it is none of them. */
    fun indexOf(lesson: Lesson): Int = all.indexOfFirst { it.name == lesson.name }

    /** The strand that [lesson] is in. */
    fun strandOf(lesson: Lesson): Strand = strands.first { it.name == lesson.strand }

    /** Every lesson in Robolang that is not about one brick, with a robot that has a [brick], also those that it cannot do. */
    internal fun allOn(brick: BrickKind): List<Lesson> = folders()
        .filter { (_, files) ->
            files.keys.any { ProgramLanguage.ofFile(it)?.support?.bricks.orEmpty().contains(brick) }
        }
        .map { (folder, files) -> Triple(folder, files, plainVersion(files)) }
        .filterNot { (_, _, plain) -> plain.isForOneBrick }
        .map { (folder, files, plain) -> lesson(folder, brick, files, { versionFor(brick, plain, files) }) }

    /** The folders of the lessons, in their order, with their files. */
    private fun folders(): List<Pair<String, Map<String, String>>> =
        lessonTexts.keys.groupBy { it.substringBeforeLast('/') }.toList().sortedBy { it.first }
            .map { (folder, paths) -> folder to textsIn(lessonTexts, paths) }

    private fun lessonOf(folder: String, files: Map<String, String>): Lesson {
        val plain by lazy { plainVersion(files) }
        val name = nameOf(folder)
        val bricks = (BrickKind.entries - BrickKind.default).filter { name in (LESSONS_OF_HUBS[it] ?: listOf(name)) }
        val versions = bricks.associateWith { brick ->
            lazy { lesson(folder, brick, files, { versionFor(brick, plain, files) }) }
        }
        val others = { if (plain.isForOneBrick) emptyMap() else versions }
        return lesson(folder, BrickKind.default, files, { plain }, others)
    }

    private fun lesson(
        folder: String,
        brick: BrickKind,
        files: Map<String, String>,
        version: () -> LessonVersion,
        others: () -> Map<BrickKind, Lazy<Lesson>> = { emptyMap() },
    ): Lesson = Lesson(
        nameOf(folder),
        folder.substringBefore('/'),
        onOtherBricks = others,
        version = version,
    ) { language, inBlocks ->
        val text = LessonText.of(files.translated("text", language), inBlocks, brick)
        if (brick == BrickKind.default) text else text.withCode { onPenbot(brick, it) }
    }

    private fun nameOf(folder: String) = folder.substringAfter('/').replace(NUMBER, "")

    private val NUMBER = Regex("^[0-9]+-")
}

/** The names of the lessons that a hub's robot can do; other bricks have all. */
private val LESSONS_OF_HUBS: Map<BrickKind, List<String>> by lazy {
    val sections = sections(commonLessonTexts.getValue("hubs.md"), "## ")
    sections.associate { section ->
        BrickKind.entries.single { it.fileWord == section.heading } to section.body.split(",").map { it.trim() }
    }
}

/** How files call it. */
internal val BrickKind.fileWord: String get() = name.lowercase().replace('_', '-')

/** The texts at [paths] of [all], by the name of their file. */
internal fun textsIn(all: Map<String, String>, paths: List<String>): Map<String, String> =
    LazyTexts(paths.associateBy { it.substringAfterLast('/') }, all::getValue)

/** The file [name] in [language], such as `text.de.md`; in English as long as nobody has translated it. */
internal fun Map<String, String>.translated(name: String, language: Language): String =
    this["$name.${language.tag}.md"] ?: getValue("$name.${Language.ENGLISH.tag}.md")

internal fun isProgram(file: String): Boolean = ProgramLanguage.ofFile(file) != null

/** How the file of a solution is called, apart from its extension. */
internal const val SOLUTION = "solution."

/** Reads a world that comes with the app. Fails if the file is invalid. */
internal fun worldOf(text: String): World = when (val result = readWorld(text, Language.ENGLISH)) {
    is WorldFileResult.Success -> result.world
    is WorldFileResult.Failure -> error(result.message)
}

package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.support
import robotran.world.World

/**
 * What `learning/worlds/NAME` has about a world.
 *
 * @param files their texts by name: `text.en.md` and the others, the program to begin with, `solution` with its
 * extension, and for each harder variation `harder-N.world.json` and its solution `harder-N` with the extension. Each
 * solution may be there in other languages, too.
 */
internal class WorldFolder(
    private val name: String,
    private val level: WorldLevel,
    private val files: Map<String, String>,
) {
    private val start = files.entries.singleOrNull {
        isProgram(it.key) && !it.key.startsWith(SOLUTION) && !it.key.startsWith(HARDER)
    }?.let { SourceFile(it.key, it.value) }

    /** The world with the text [file]. */
    fun world(file: String): GalleryWorld {
        val harder = files.keys.filter { it.startsWith(HARDER) && it.endsWith(WorldGallery.WORLD_FILE) }.sorted()
        return GalleryWorld(
            name,
            level,
            harder.mapIndexed { index, world -> variation(index, world) },
            file,
            given(SOLUTION),
            { titleIn(textIn(it)) },
            { plainWorld ->
                start?.let {
                    lesson("world/$name", it, SOLUTION, plainWorld) { language, inBlocks ->
                        LessonText.of(textIn(language), inBlocks, BrickKind.default)
                    }
                }
            },
        )
    }

    private fun variation(index: Int, worldFile: String): GalleryWorld {
        val stem = worldFile.removeSuffix(WorldGallery.WORLD_FILE)
        val given = requireNotNull(start) { "$name has no program to begin with." }
        val text = { language: Language, inBlocks: Boolean ->
            LessonText.ofHarder(textIn(language), index, inBlocks)
        }
        return GalleryWorld(
            "$name/$stem",
            level,
            emptyList(),
            files.getValue(worldFile),
            given("$stem."),
            { language -> text(language, false).let { WorldTitle(it.title, withoutBackticks(it.task), it.goals) } },
            { lesson("world/$name/$stem", given, "$stem.", it, text) },
        )
    }

    /** The program to begin with, and the files that begin with [solution], named as in the app. */
    private fun given(solution: String): List<SourceFile> {
        val solutions = files.entries.filter { it.key.startsWith(solution) && isProgram(it.key) }
        return listOfNotNull(start) + solutions.map { SourceFile(tabOfSolution(it.key), it.value) }
    }

    /** The task called [name], whose solutions are the files that begin with [solution]. */
    private fun lesson(
        name: String,
        given: SourceFile,
        solution: String,
        world: World,
        read: (language: Language, inBlocks: Boolean) -> LessonText,
    ): Lesson {
        val stem = solution.removeSuffix(".")
        val own = checkNotNull(ProgramLanguage.ofFile(given.name)) { given.name }
        val others = (ProgramLanguage.entries - own).mapNotNull { language ->
            files[stem + language.extension]?.let { SourceFile(nameOfSolution(language), it) }
        }
        val brick = world.robots.first().description.brick
        val solved = SourceFile(given.name, files.getValue(stem + own.extension))
        return Lesson(name, "", others, version = {
            LessonVersion(brick, given, solved, world, drawing = null)
        }, read = read)
    }

    private fun textIn(language: Language): String = files.translated("text", language)

    private companion object {
        const val HARDER = "harder-"

        fun tabOfSolution(file: String) = nameOfSolution(checkNotNull(ProgramLanguage.ofFile(file)) { file })

        fun nameOfSolution(language: ProgramLanguage) = language.support.files.nameFor("solution")
    }
}

/** Title, task and goals in the text [file]. */
private fun titleIn(file: String): WorldTitle {
    val whole = sections(file).single()
    val parts = sections(whole.body, "## ").associate { it.heading to it.body }
    val task = paragraphs(parts.getValue("Task")).joinToString(" ")
    return WorldTitle(whole.heading, withoutBackticks(task), goalSentences(parts[GOALS].orEmpty()))
}

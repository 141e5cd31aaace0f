package robotran.learning

import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.world.World

enum class WorldLevel { EASY, MEDIUM, HARD }

/**
 * A world that comes with the app, or a harder variation of one.
 *
 * @property name the name of its file without the extension, such as `line-loop`; `line-loop/harder-1` for a variation.
 * @param given the programs that come with it, under the names of their tabs.
 * @property harder worlds in which the same task is harder; a variation has none.
 */
class GalleryWorld internal constructor(
    val name: String,
    val level: WorldLevel,
    val harder: List<GalleryWorld>,
    file: String,
    private val given: List<SourceFile>,
    titles: (Language) -> WorldTitle,
    task: (World) -> Lesson?,
) {
    /** The world in English. */
    val plainWorld: World by lazy { worldOf(file) }

    /** What to do here, with a program to begin with, hints and a solution; null where one does what one likes. */
    val lesson: Lesson? by lazy { task(plainWorld) }

    /** Whether the file [name] with [text] is this world's program to begin with, or a solution that it shows. */
    fun gives(name: String, text: String): Boolean = given.any { it.name == name && it.text == text }

    private val titles by lazy { Language.entries.associateWith(titles) }

    /** The world with title, task and goals in [language]. */
    fun world(language: Language): World {
        val said = titles.getValue(language)
        return plainWorld.withGoalsSaid(titles.getValue(Language.ENGLISH).goals, said.goals)
            .copy(title = said.title, task = said.task)
    }
}

internal class WorldTitle(val title: String, val task: String, val goals: List<String>)

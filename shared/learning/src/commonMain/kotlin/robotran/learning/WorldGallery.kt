package robotran.learning

import robotran.language.Language
import robotran.world.World
import robotran.world.file.BuiltInWorlds

enum class WorldLevel { EASY, MEDIUM, HARD }

/**
 * A world that comes with the app.
 *
 * @property name the name of its file without the extension, such as `line-loop`.
 */
class GalleryWorld internal constructor(val name: String, val level: WorldLevel, val plainWorld: World) {
    /** The world with title and task in [language]. */
    fun world(language: Language): World {
        val translated = translatedTitles(language)[name] ?: return plainWorld
        return plainWorld.copy(title = translated.title, task = translated.task)
    }
}

/** The worlds that come with the app, the easy ones first. */
object WorldGallery {
    val worlds: List<GalleryWorld> by lazy {
        sections(worldTitleTexts.getValue("levels.md")).flatMap { section ->
            val level = WorldLevel.valueOf(section.heading.uppercase())
            section.body.lines().map { it.removePrefix("- ") }.map { name ->
                GalleryWorld(name, level, worldOf(BuiltInWorlds.texts.getValue(name + WORLD_FILE)))
            }
        }
    }

    /** The gallery world that equals [world] apart from its language, seed and realism; null if there is none. */
    fun find(world: World): GalleryWorld? = worlds.firstOrNull { it.plainWorld.isSameWorldAs(world) }

    /** The gallery world called [name]; null if there is none. */
    fun named(name: String): GalleryWorld? = worlds.firstOrNull { it.name == name }

    /** The worlds whose title or task in [language] contains all words of [query]; all worlds if it has no words. */
    fun search(query: String, language: Language): List<GalleryWorld> {
        val words = query.lowercase().split(' ').filter { it.isNotEmpty() }
        return worlds.filter { found ->
            val world = found.world(language)
            val text = "${world.title} ${world.task}".lowercase()
            words.all { it in text }
        }
    }

    internal const val WORLD_FILE = ".world.json"
}

/** Whether [other] is the same apart from its title, task, seed and realism. */
internal fun World.isSameWorldAs(other: World): Boolean = paper == other.paper &&
    goals == other.goals &&
    copy(title = other.title, task = other.task, seed = other.seed, realism = other.realism) == other

internal class WorldTitle(val title: String, val task: String)

/** Titles and tasks by world name; empty for English, the language of the world files. */
internal fun translatedTitles(language: Language): Map<String, WorldTitle> = titles.getOrPut(language) {
    val text = worldTitleTexts["${language.tag}.md"] ?: return@getOrPut emptyMap()
    sections(text).associate { section ->
        val paragraphs = paragraphs(section.body)
        section.heading to WorldTitle(paragraphs[0], paragraphs.drop(1).joinToString(" "))
    }
}

private val titles = mutableMapOf<Language, Map<String, WorldTitle>>()

package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.world.Goal
import robotran.world.ReadyRobots
import robotran.world.World
import robotran.world.file.BuiltInWorlds

/** The worlds that come with the app, the easy ones first. */
object WorldGallery {
    /** All of them, without their harder variations. */
    val worlds: List<GalleryWorld> by lazy {
        val files = worldTaskTexts.entries.groupBy({ it.key.substringBefore('/') }) {
            it.key.substringAfter('/') to it.value
        }
        sections(worldLevels.getValue("levels.md")).flatMap { section ->
            val level = WorldLevel.valueOf(section.heading.uppercase())
            section.body.lines().map { it.removePrefix("- ") }.map { name ->
                WorldFolder(name, level, files.getValue(name).toMap()).world(
                    BuiltInWorlds.texts.getValue(name + WORLD_FILE),
                )
            }
        }
    }

    /**
     * The bricks that their robots have. The name of a world for another brick than the default one begins like that of
     * the brick's ready robot, such as `nxt-`, or with `buggy-`, so no world is read for this.
     */
    val bricks: List<BrickKind> by lazy {
        val words = worlds.mapTo(mutableSetOf()) { it.name.substringBefore('-') }
        BrickKind.entries.distinctBy(::wordOf).filter { it == BrickKind.default || wordOf(it) in words }
    }

    private fun wordOf(brick: BrickKind) =
        if (brick.isOnBuggy) BUGGY else ReadyRobots.defaultOf(brick).base?.substringBefore('-')

    private val withHarder: List<GalleryWorld> by lazy { worlds + worlds.flatMap { it.harder } }

    /** The gallery world or variation that equals [world] apart from language, seed and realism; null if none does. */
    fun find(world: World): GalleryWorld? =
        if (world.goals.isEmpty()) null else withHarder.firstOrNull { it.plainWorld.isSameWorldAs(world) }

    /** The gallery world or variation called [name]; null if there is none. */
    fun named(name: String): GalleryWorld? = withHarder.firstOrNull { it.name == name }

    /** What goes on from [world]: the harder variations of it, or of the world that it is a variation of. */
    fun harderThan(world: GalleryWorld): List<GalleryWorld> =
        worlds.first { it === world || world in it.harder }.harder - world

    /**
     * The worlds that have all words of [query] in their title or task in [language], in what [robotLine] says about
     * their robot, in the names of its sensors, or in those of the languages of their solutions; those that say them in
     * title or task come first. All worlds if [query] has no words.
     */
    fun search(query: String, language: Language, robotLine: (GalleryWorld) -> String = { "" }): List<GalleryWorld> {
        val words = query.lowercase().split(' ').filter { it.isNotEmpty() }
        if (words.isEmpty()) return worlds
        return worlds.mapNotNull { found ->
            val world = found.world(language)
            val searched = "${world.title} ${world.task}".lowercase()
            val robot = "${robotLine(found)} ${robotWords(world.robots.first().description, language)}".lowercase()
            val languages = found.lesson?.solutions.orEmpty()
                .mapNotNull { ProgramLanguage.ofFile(it.name)?.ownName?.lowercase() }
            when {
                words.all { it in searched } -> found to 0
                words.all { it in searched || it in robot || it in languages } -> found to 1
                else -> null
            }
        }.sortedBy { it.second }.map { it.first }
    }

    /** Whether the file [name] with [text] is a program that comes with a world: one to begin with or a solution. */
    fun isGiven(name: String, text: String): Boolean = withHarder.any { it.gives(name, text) }

    internal const val WORLD_FILE = ".world.json"

    /** What the name of a world for a board on a buggy begins with. */
    private const val BUGGY = "buggy"
}

/** Whether [other] is the same apart from its title, its task, what its goals say, seed and realism. */
internal fun World.isSameWorldAs(other: World): Boolean = paper == other.paper &&
    silent(goals) == silent(other.goals) &&
    copy(
        title = other.title,
        task = other.task,
        goals = other.goals,
        seed = other.seed,
        realism = other.realism,
    ) == other

private fun silent(goals: List<Goal>): List<Goal> = goals.map { goal -> goal.withSays { null } }

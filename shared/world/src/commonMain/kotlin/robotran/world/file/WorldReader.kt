package robotran.world.file

import robotran.json.JsonCursor
import robotran.json.JsonFormat
import robotran.json.JsonValidationException
import robotran.world.Light
import robotran.world.Paper
import robotran.world.Template
import robotran.world.UnknownFields
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.messages.reason

/**
 * The world in a file, or in a part of one, of any format version.
 *
 * @throws JsonValidationException if it is invalid.
 */
fun worldIn(cursor: JsonCursor): World {
    val version = FORMAT.versionOf(cursor)
    return if (version < WORLD_VERSION) readMigrated(cursor) else WorldReader(cursor).read()
}

private fun readMigrated(cursor: JsonCursor): World {
    val migration = MigrationFromVersion1(cursor)
    try {
        return WorldReader(cursor.with(migration.migrated, migration::pathBefore)).read()
    } catch (refusal: JsonValidationException) {
        throw JsonValidationException(refusal.path?.let(migration::pathBefore), refusal.form, refusal.reason)
    }
}

internal const val WORLD_FORMAT = "robotran-world"
internal const val WORLD_VERSION = 2
private val FORMAT = JsonFormat(
    WORLD_FORMAT,
    WORLD_VERSION,
    reason { notAWorld(WORLD_FORMAT) },
    { version -> reason { newerWorld(version, WORLD_VERSION) } },
)

/** Builds a [World] from the fields of a file. */
private class WorldReader(private val file: JsonCursor) {
    private val shapes = ShapeReader()
    private val things = ElementReader(shapes)

    fun read(): World {
        file.member("format")
        file.member("version")
        val paper = readPaper(file.member("paper"))
        val world = World(
            title = file.member("title").text(WorldLimits.MAXIMUM_TITLE_CHARACTERS),
            task = file.optional(
                "task",
            )?.text(WorldLimits.MAXIMUM_TASK_CHARACTERS, mayBeEmpty = true, severalLines = true).orEmpty(),
            paper = paper,
            robots = file.member("robots").items(1..WorldLimits.MAXIMUM_ROBOTS).map { readRobot(it, paper) },
            walls = list("walls", WorldLimits.MAXIMUM_WALLS, things::wall),
            barriers = list("barriers", WorldLimits.MAXIMUM_BARRIERS, things::barrier),
            blocks = list("blocks", WorldLimits.MAXIMUM_BLOCKS, things::block),
            marks = list("marks", WorldLimits.MAXIMUM_MARKS, things::mark),
            lamps = list("lamps", WorldLimits.MAXIMUM_LAMPS, things::lamp),
            ambientLight = file.optional("light")?.number(0.0..WorldLimits.MAXIMUM_BRIGHTNESS) ?: Light.DIM_ROOM,
            temperature =
                file.optional("temperature")?.number(WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE)
                    ?: World.ROOM_TEMPERATURE,
            template = file.optional("template")?.let(::readTemplate),
            goals = file.optional("goals")?.let { GoalReader(shapes).read(it) }.orEmpty(),
            timeLimit = file.optional("timeLimit")?.wholeNumber(WorldLimits.SECONDS) ?: World.DEFAULT_TIME_LIMIT,
            realism = file.optional("realism")?.number(0.0..1.0) ?: 0.0,
            seed = file.optional("seed")?.wholeNumber(0..Int.MAX_VALUE) ?: 1,
            unknown = unknownOf(file),
        )
        checkNames(world, file)
        checkStarts(world, file)
        return world
    }

    private fun <T> list(name: String, maximum: Int, read: (JsonCursor) -> T): List<T> =
        file.optional(name)?.items(0..maximum)?.map(read).orEmpty()

    private fun readPaper(cursor: JsonCursor): Paper {
        val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
        return Paper(cursor.member("width").number(sides), cursor.member("height").number(sides), unknownOf(cursor))
    }

    private fun readTemplate(cursor: JsonCursor): Template {
        val strokes = cursor.member("strokes").items(1..WorldLimits.MAXIMUM_STROKES)
        return Template(strokes.map { shapes.way(it, 2, closed = false) }, unknownOf(cursor))
    }
}

/** The members of [cursor] that have not been read. */
fun unknownOf(cursor: JsonCursor): UnknownFields =
    cursor.rest().let { if (it.isEmpty()) UnknownFields.NONE else UnknownFields(it) }

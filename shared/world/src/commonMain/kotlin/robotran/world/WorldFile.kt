package robotran.world

/**
 * Reads a world file; `docs/worlds.md` describes the format. Whatever the text is, this ends quickly and with a result: a file
 * is either read as it is meant or refused. Fields that this version does not know are passed over.
 */
fun readWorld(text: String): WorldFileResult =
    try {
        WorldFileResult.Loaded(WorldReader(parseJson(text)).read())
    } catch (refusal: WorldRefusal) {
        WorldFileResult.Refused(refusal.sentence)
    }

/** Ends the reading of a file; never leaves [readWorld]. */
internal class WorldRefusal(val sentence: String) : Exception(sentence)

/** Builds a [World] from the fields of a file. */
private class WorldReader(private val file: JsonPlace) {
    fun read(): World {
        checkFormat()
        val paper = readPaper(file.member("paper"))
        val walls = file.member("walls").items(WorldLimits.MAXIMUM_WALLS)
        return World(
            title = file.member("name").text(WorldLimits.MAXIMUM_NAME_CHARACTERS),
            paper = paper,
            walls = walls.map(::readWall),
            robots = listOf(RobotPlace(readStart(file.member("start"), paper))),
            seed = file.member("seed").wholeNumber(),
        ).also { checkRoom(it, walls) }
    }

    private fun checkFormat() {
        if (file.optionalMember("format")?.textOrNull() != FORMAT) {
            throw WorldRefusal("This is not a Robotran world: a world file says \"format\": \"$FORMAT\".")
        }
        val version = file.member("version").wholeNumber()
        if (version > VERSION) {
            throw WorldRefusal("This world was made by a newer Robotran (it has version $version, this Robotran reads up to $VERSION).")
        }
        if (version < VERSION) throw WorldRefusal("There is no version $version of the world format.")
    }

    private fun readPaper(place: JsonPlace): Paper {
        val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
        return Paper(place.member("width").number(sides), place.member("height").number(sides))
    }

    private fun readWall(place: JsonPlace) = Wall(
        from = readPoint(place.member("from")),
        to = readPoint(place.member("to")),
        thickness = place.member("thickness").number(WorldLimits.MINIMUM_WALL_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS),
    )

    private fun readPoint(place: JsonPlace): Point {
        val coordinates = WorldLimits.MINIMUM_COORDINATE..WorldLimits.MAXIMUM_COORDINATE
        return Point(place.member("x").number(coordinates), place.member("y").number(coordinates))
    }

    private fun readStart(place: JsonPlace, paper: Paper): Pose {
        val point = readPoint(place)
        if (!paper.contains(point.x, point.y)) throw WorldRefusal("The robot's start is beside the paper (at ${place.path}).")
        val heading = place.member("heading").number(-WorldLimits.MAXIMUM_HEADING..WorldLimits.MAXIMUM_HEADING)
        return Pose(point.x, point.y, normalHeading(heading))
    }

    private fun checkRoom(world: World, walls: List<JsonPlace>) {
        val start = Point(world.start.x, world.start.y)
        world.walls.forEachIndexed { number, wall ->
            if (distance(start, wall.from, wall.to) < wall.thickness / 2 + Penbot.OVERALL_WIDTH / 2) {
                throw WorldRefusal("The robot would start in a wall (the one at ${walls[number].path}).")
            }
        }
    }

    private companion object {
        const val FORMAT = "robotran-world"
        const val VERSION = 1
    }
}

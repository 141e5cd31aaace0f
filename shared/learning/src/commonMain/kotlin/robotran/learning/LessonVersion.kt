package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.languagesupport.SourceFile
import robotran.learning.drawing.RunDrawing
import robotran.learning.drawing.readRunDrawing
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.World

/**
 * What a lesson has for one kind of brick.
 *
 * @param again reads the world of [LessonPlace.AGAIN], once it is needed; null if the lesson has one place.
 */
internal class LessonVersion(
    val brick: BrickKind,
    val program: SourceFile,
    val solution: SourceFile,
    val world: World,
    val drawing: RunDrawing?,
    again: () -> World? = { null },
) {
    /** The world of [LessonPlace.AGAIN]; null if the lesson has one place. */
    val again: World? by lazy(again)
}

/** Whether the lesson as it is written, this version, is about one brick, so that there is none for others. */
internal val LessonVersion.isForOneBrick: Boolean get() = brick != BrickKind.default

/** The lesson in [files] as it is written: for the robot that its world names, otherwise with the [BrickKind.default]. */
internal fun plainVersion(files: Map<String, String>): LessonVersion {
    val programs = files.filterKeys { file ->
        isProgram(file) && BrickKind.entries.none { file.startsWith(prefixFor(it)) }
    }
    val program = programs.entries.single { !it.key.startsWith(SOLUTION) }
    val world = worldOf(files.getValue(WORLD))
    return LessonVersion(
        world.robots.first().description.brick,
        SourceFile(program.key, program.value),
        SourceFile(program.key, programs.entries.single { it.key.startsWith(SOLUTION) }.value),
        world,
        drawingIn(files, DRAWING),
    ) { files[AGAIN]?.let(::worldOf) }
}

/**
 * The lesson [plain] with the penbot of another [brick] instead. World and programs are the same, unless [files] has
 * others, whose names begin with the brick's, such as `nxt-`, or with that of the brick that it is like; only the light
 * sensor and the wheels are on other ports.
 */
internal fun versionFor(brick: BrickKind, plain: LessonVersion, files: Map<String, String>): LessonVersion {
    fun own(file: String): String? = brick.marks.firstNotNullOfOrNull { files[prefixFor(it) + file] }
    val name = plain.program.name
    val solution = SOLUTION + name.substringAfterLast('.')
    val ownWorld = own(WORLD)?.let(::worldOf)
    return LessonVersion(
        brick,
        SourceFile(name, onPenbot(brick, own(name) ?: plain.program.text)),
        SourceFile(name, onPenbot(brick, own(solution) ?: plain.solution.text)),
        (ownWorld ?: plain.world).withFirst(PUPILS_ROBOTS.getValue(brick)),
        if (ownWorld == null) plain.drawing else own(DRAWING)?.let { readRunDrawing(it.trim()) },
    ) { (own(AGAIN)?.let(::worldOf) ?: plain.again)?.withFirst(PUPILS_ROBOTS.getValue(brick)) }
}

/** The bricks whose own files and paragraphs a lesson with this brick has, the nearest first: itself and those like it. */
internal val BrickKind.marks: List<BrickKind>
    get() {
        val boards = BrickKind.entries.filter { isOnBuggy && it.isOnBuggy }
        return (listOf(this) + boards + BrickKind.entries.first { it.hasMotorCounters == hasMotorCounters }).distinct()
    }

private fun drawingIn(files: Map<String, String>, file: String): RunDrawing? =
    files[file]?.let { readRunDrawing(it.trim()) }

/** [code], a program or a part of one, with the ports of the penbot with this [brick]. */
internal fun onPenbot(brick: BrickKind, code: String): String {
    val usual = lightPortOf(BrickKind.default)
    val other = lightPortOf(brick) ?: usual
    val drive = ReadyRobots.defaultOf(brick).drive
    val plain = ReadyRobots.defaultOf(BrickKind.default).drive
    val wheels = mapOf(plain.left.name to drive.left.name, plain.right.name to drive.right.name)
    return MOTOR.replace(code.replace("light sensor on $usual", "light sensor on $other")) { motor ->
        val letter = motor.groupValues[1]
        "motor ${wheels[letter] ?: letter}"
    }
}

private val MOTOR = Regex("\\bmotor ([A-C])\\b")

/** The port of the sensor that measures the light on the floor of the penbot with this [brick]; null if it has none. */
private fun lightPortOf(brick: BrickKind): Int? =
    ReadyRobots.defaultOf(brick).parts.firstOrNull { it.kind == SensorKind.LIGHT || it.kind == SensorKind.COLOUR }?.port

/** What the names of the files that are only for this [brick] begin with. */
private fun prefixFor(brick: BrickKind) = "${brick.name.lowercase()}-"

/** The same world, in which the penbot is the one of the lessons. */
internal fun World.withPupilsPenbot(): World {
    val robot = robots.first().description
    return if (robot == ReadyRobots.defaultOf(robot.brick)) withFirst(PUPILS_ROBOTS.getValue(robot.brick)) else this
}

private fun World.withFirst(robot: RobotDescription): World =
    copy(robots = listOf(robots.first().copy(description = robot)) + robots.drop(1))

/** The penbots, whose light sensor can be turned ahead, as that of an RCX always. */
private val PUPILS_ROBOTS: Map<BrickKind, RobotDescription> = BrickKind.entries.associateWith { brick ->
    val penbot = ReadyRobots.defaultOf(brick)
    penbot.copy(
        parts = penbot.parts.map { part ->
            if (part is SensorPart && part.facing == Facing.Down) part.copy(facing = Facing.Free) else part
        },
    )
}

private const val WORLD = "world.world.json"
private const val AGAIN = "again.world.json"

/** What the run of the solution leaves on the sheet. */
internal const val DRAWING = "drawing.txt"

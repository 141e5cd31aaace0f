package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.languagesupport.SourceFile
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.World

/** What a lesson has for one kind of brick. */
internal class LessonVersion(val brick: BrickKind, val program: SourceFile, val solution: SourceFile, val world: World)

/** The lesson in [files] as it is written: for a robot with an RCX. */
internal fun versionForRcx(files: Map<String, String>): LessonVersion {
    val programs = files.filterKeys { isProgram(it) && !it.startsWith(NXT_FILE) }
    val program = programs.entries.single { !it.key.startsWith(SOLUTION) }
    return LessonVersion(
        BrickKind.RCX,
        SourceFile(program.key, program.value),
        SourceFile(program.key, programs.entries.single { it.key.startsWith(SOLUTION) }.value),
        worldOf(files.getValue(WORLD)),
    )
}

/**
 * The lesson [rcx] with the penbot of an NXT instead. World and programs are the same, unless [files] has others, whose
 * names begin with `nxt-`; only the light sensor is on another port.
 */
internal fun versionForNxt(rcx: LessonVersion, files: Map<String, String>): LessonVersion {
    val ending = rcx.program.name.substringAfterLast('.')
    val program = files[NXT_FILE + rcx.program.name] ?: onNxtPenbot(rcx.program)
    val solution = files["$NXT_FILE$SOLUTION$ending"] ?: onNxtPenbot(rcx.solution)
    val world = files[NXT_FILE + WORLD]?.let(::worldOf) ?: rcx.world
    return LessonVersion(
        BrickKind.NXT,
        SourceFile(rcx.program.name, program),
        SourceFile(rcx.program.name, solution),
        world.withFirst(PUPILS_NXT),
    )
}

private fun onNxtPenbot(file: SourceFile): String = file.text.replace("light sensor on 2", "light sensor on 3")

/** The same world, in which the NXT penbot is the one of the lessons. */
internal fun World.withPupilsPenbot(): World =
    if (robots.first().description == ReadyRobots.NXT_PENBOT) withFirst(PUPILS_NXT) else this

private fun World.withFirst(robot: RobotDescription): World =
    copy(robots = listOf(robots.first().copy(description = robot)) + robots.drop(1))

/** The penbot, whose light sensor can be turned ahead, as that of an RCX. */
private val PUPILS_NXT: RobotDescription = ReadyRobots.NXT_PENBOT.let { penbot ->
    penbot.copy(
        parts = penbot.parts.map { part ->
            if (part is SensorPart && part.facing == Facing.Down) part.copy(facing = Facing.Free) else part
        },
    )
}

private const val NXT_FILE = "nxt-"
private const val WORLD = "world.world.json"

package robotran.runsound

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.Barrier
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.assertIs

/** A run of [source] that has just begun: Run was pressed. */
internal suspend fun started(source: String, world: World): Session {
    val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
    val compiled = compileRobolang("test", source, target, messages = RobolangMessages.of(Language.ENGLISH))
    val load = RobotProgramSet(listOf(assertIs<RobolangResult.Success>(compiled).program))
    val session = Session(world, listOf(load), loadPhysicsEngine(), Language.ENGLISH)
    session.apply(SessionInput.Press(BrickButton.RUN))
    session.apply(SessionInput.Release(BrickButton.RUN))
    return session
}

/** The states of this run for [milliseconds], as often as it is looked at for its sounds. */
internal fun Session.looks(milliseconds: Int): Sequence<SessionState> = sequence {
    yield(state)
    repeat(milliseconds / RunSound.LOOK_MILLISECONDS.toInt()) {
        advance(RunSound.LOOK_MILLISECONDS.toInt())
        yield(state)
    }
}

/** What is heard of the first [milliseconds] of a run of [source]. */
internal suspend fun heard(source: String, milliseconds: Int, world: World = plain()): List<RunTone> {
    val session = started(source, world)
    val sound = RunSound(world, robot = 0)
    return session.looks(milliseconds).flatMap(sound::observe).toList().also { session.close() }
}

/** An empty sheet, with the robot at [start]. */
internal fun plain(start: Pose = Pose(20.0, 40.0, 0.0)): World =
    BuiltInWorlds.plain.withStart(start).copy(walls = emptyList(), goals = emptyList(), marks = emptyList())

/** With a box whose left side is at [x], across the sheet. */
internal fun World.withBox(x: Double): World =
    copy(barriers = listOf(Barrier(Shape.Rectangle(Point(x + 3, 40.0), 6.0, 60.0))))

/** With a black strip across the sheet that begins at [x]. */
internal fun World.withStrip(x: Double): World =
    copy(marks = listOf(Mark(MarkFigure.Area(Shape.Rectangle(Point(x + 4, 40.0), 8.0, 60.0)))))

internal fun List<RunTone>.of(sign: RunSign): List<RunTone> = filter { it.sign == sign }

/** A tone in a line, with all that it is. */
internal fun RunTone.line(): String = "$milliseconds $sign $hertz $duration $pan $timbre $loudness"

package robotran.benchmarks

import robotran.animatedpicture.AnimationStep
import robotran.animatedpicture.FrameSource
import robotran.animatedpicture.animatedGif
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.projects.PENBOT_TARGET
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSetup
import robotran.simulation.RobotProgramSet
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.picture.WorldFrames
import robotran.simulation.state.SessionState
import robotran.ui.pictures.DrawnWorldPictures
import robotran.world.file.BuiltInWorlds
import kotlin.time.DurationUnit
import kotlin.time.TimeSource

/**
 * The time to make a moving picture of a minute's run in which the robot draws all the time, [faster] than it was, and
 * the size of the file.
 */
internal suspend fun movingPictureTime(faster: Int): Measurement {
    val source = Program.of("flowers.robo", FLOWERS)
    val program = (
        ProgramCompiler(
            PENBOT_TARGET,
            language = Language.ENGLISH,
        ).compileOrThrow(source) as ProgramResult.Success
    ).program
    val world = BuiltInWorlds.plain
    val player =
        RunPlayer(RunSetup(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), Language.ENGLISH))
    player.apply(SessionInput.Press(BrickButton.RUN, 0))
    player.apply(SessionInput.Release(BrickButton.RUN, 0))
    player.pass(MINUTE)
    val start = TimeSource.Monotonic.markNow()
    val states = player.recorded().states(FRAME_MILLISECONDS * faster).toList()
    val repeated = start.elapsedNow().toDouble(DurationUnit.SECONDS)
    val frames = DrawnWorldPictures().frames(world, SIDE)
    val bytes = (animatedGif(Frames(states, frames)).last() as AnimationStep.Finished).bytes
    val note = "${states.size} frames, ${rounded(bytes.size / BYTES_PER_MEGABYTE)} MB; " +
        "${rounded(repeated)} s of it to repeat the run"
    player.close()
    return Measurement(start.elapsedNow().toDouble(DurationUnit.SECONDS), "s", note)
}

private class Frames(private val states: List<SessionState>, private val frames: WorldFrames) : FrameSource {
    override val width: Int get() = frames.width
    override val height: Int get() = frames.height
    override val count: Int get() = states.size
    override val frameMilliseconds: Int get() = FRAME_MILLISECONDS

    override fun draw(index: Int, pixels: IntArray) = frames.draw(states[index], pixels)
}

/** More than a minute of petals, in ever new places. */
private const val FLOWERS = """pen down
repeat 30 times
  repeat 20 times
    forward 1.5
    turn left 12
  end
  turn left 25
end"""

private const val MINUTE = 60_000

/** As the app makes them. */
private const val FRAME_MILLISECONDS = 80
private const val SIDE = 640
private const val BYTES_PER_MEGABYTE = 1e6

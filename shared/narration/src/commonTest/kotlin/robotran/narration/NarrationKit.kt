package robotran.narration

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSetup
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.Penbot
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.geometry.Pose
import kotlin.test.assertIs

/** A run of [source] on all robots of [world], after [milliseconds] or where it has paused before. */
internal suspend fun runOf(
    source: String,
    world: World = BuiltInWorlds.plain,
    milliseconds: Int = 60_000,
    language: Language = Language.ENGLISH,
): RunPlayer {
    val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
    val program = assertIs<RobolangResult.Success>(
        compileRobolang("test", source, target, messages = RobolangMessages.of(language)),
    ).program
    val loads = world.robots.map { RobotProgramSet(listOf(program)) }
    val player = RunPlayer(RunSetup(world, loads, loadPhysicsEngine(), language))
    for (robot in world.robots.indices) {
        player.apply(SessionInput.Press(BrickButton.RUN, robot))
        player.apply(SessionInput.Release(BrickButton.RUN, robot))
    }
    repeat(milliseconds / 100) { if (player.playback != PlaybackState.Paused) player.pass(100) }
    return player
}

internal fun RunPlayer.story(world: World, language: Language = Language.ENGLISH): List<String> =
    storyOf(world, history, outcome.goals).sentences(language)

internal fun worldOf(name: String): World = assertIs<WorldFileResult.Success>(
    readWorld(BuiltInWorlds.texts.getValue("$name.world.json"), Language.ENGLISH),
).world

/** The state of [world] before anything has happened, with the first robot at [pose]. */
internal suspend fun stateOf(world: World, pose: Pose = world.start): SessionState {
    val session = Session(world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
    if (pose != world.start) session.apply(SessionInput.PlaceRobot(0, pose))
    session.advance(20)
    return session.state.also { session.close() }
}

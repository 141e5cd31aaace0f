package robotran.workshop.run

import robotran.language.Language
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSetup
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.SoundPlayer
import robotran.workshop.state.Notice
import robotran.world.World

/**
 * The run that is watched, with its sound; one after the other, since whenever the robots go back to their starts
 * another begins.
 *
 * @param world what the first takes place in.
 */
internal class WatchedRun(
    world: World,
    private val physics: PhysicsEngine,
    private val programs: ProgramsStateHolder,
    speaker: LoudSpeaker,
    private val preferences: Preferences,
    private val notices: Notices,
) {
    private val sound = SoundPlayer(speaker)
    private var loaded = programs.written

    /** What it takes place in. */
    var world = world
        private set

    /** The program of each robot that Run starts, or would start, as long as Prgm was not pressed. */
    var firstSlots = programs.slotsBeginning(programs.slotToRun)
        private set

    private lateinit var setup: RunSetup

    var player = newPlayer(emptyList())
        private set

    private var lastSession = player.session
    private var futures = 0

    init {
        sound.listenTo(player.sounds)
    }

    /** Whether the programs differ from those on the bricks. */
    val isChanged: Boolean get() = programs.written != loaded

    /** The program that is chosen on the brick of the watched robot. */
    val slotOnBrick: Int get() = player.state.brick.selectedSlot.coerceAtMost(programs.count - 1)

    /**
     * Puts the robots at their starts in [world], with the programs as they are and [firstSlots] chosen; [inputs] will
     * be done to them.
     */
    fun beginAfresh(firstSlots: List<Int>, world: World = this.world, inputs: List<RecordedInput> = emptyList()) {
        val before = player
        before.close()
        this.world = world
        this.firstSlots = firstSlots
        loaded = programs.written
        futures = 0
        player = newPlayer(inputs).also {
            it.speed = before.speed
            if (before.watched in world.robots.indices) it.watched = before.watched
        }
    }

    /** Tells the run in [language], by programs that were read in it as far as they are the ones that run. */
    fun speak(language: Language) {
        val now = if (isChanged) setup.loads else programs.loads(world, firstSlots)
        val loads = setup.loads.zip(now) { loaded, read ->
            loaded.copy(
                programs = loaded.programs.mapIndexed { slot, program ->
                    read.programs.getOrNull(slot)
                        ?: program
                },
            )
        }
        setup = RunSetup(world, loads, physics, language)
        player.speak(language, loads)
    }

    /** Looks into another [robot] of the world, whose brick is heard from now on. */
    fun watch(robot: Int) {
        player.watched = robot
        sound.listenTo(player.sounds)
        sound.skip()
    }

    /**
     * Does what has to be done when something may have become of it: hears another session, tells of a new future,
     * stops before other lines.
     */
    fun look() {
        if (player.session !== lastSession) {
            val isAfresh = player.session.milliseconds == 0L && player.time == 0L
            lastSession = player.session
            sound.listenTo(player.sounds)
            if (!isAfresh) sound.skip()
        }
        if (player.branchCount != futures) notices.say(Notice.NewBranch)
        futures = player.branchCount
        // The lines of a program that was changed are not those of the one that runs.
        if (!isChanged) player.breakpoints = breakpoints()
    }

    /** Plays what has sounded since the last time, unless that passed too quickly. */
    fun hearWhatIsNew() {
        val isHeard =
            player.speed != RunSpeed.FASTEST &&
                (player.playback is PlaybackState.Playing || player.playback is PlaybackState.Stepping)
        if (isHeard) sound.follow() else sound.skip()
    }

    /** Leaves unheard what has sounded since the last time. */
    fun skipSound() = sound.skip()

    /** Ends what sounds. */
    fun silence() = sound.silence()

    /** Whether the brick's tones are to be heard. */
    fun hear(on: Boolean) {
        sound.muted = !on
    }

    /** Gives back what the session holds. Nothing may be called afterwards. */
    fun close() {
        sound.close()
        player.close()
    }

    private fun newPlayer(inputs: List<RecordedInput>): RunPlayer {
        setup = RunSetup(world, programs.loads(world, firstSlots), physics, preferences.language)
        return RunPlayer(setup, inputs)
    }

    private fun breakpoints(): Set<Breakpoint> =
        programs.breakpoints(world.robots[player.watched].name, player.state.robots[player.watched].brick.selectedSlot)
}

package robotran.workshop.run

import robotran.language.Language
import robotran.nxt.storage.HasFlash
import robotran.nxt.storage.NxtFile
import robotran.programs.Program
import robotran.runcontrol.IdleDetector
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSetup
import robotran.runcontrol.RunSpeed
import robotran.runsound.RunSound
import robotran.runsound.SoundSample
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.RunEar
import robotran.workshop.sound.SoundPlayer
import robotran.workshop.state.Notice
import robotran.workshop.state.Snippet
import robotran.world.World

/**
 * The current run and its sound. A new run replaces it when the robots return to their starts.
 *
 * @param world the world of the first run.
 */
internal class DebuggedRun(
    world: World,
    private val physics: PhysicsEngine,
    private val programs: ProgramsToRun,
    speaker: LoudSpeaker,
    private val preferences: Preferences,
    private val notices: Notices,
) {
    val idleDetector = IdleDetector()
    val escape = LoneEscape()
    private val sound = SoundPlayer(speaker)
    private val ear = RunEar()
    private var loaded = programs.written

    /** The programs of the first robot, as they are on its brick. */
    val loadedPrograms: List<Program> get() = loaded.programs.first()

    /** The world of the current run. */
    var world = world
        private set

    /** For each robot the slot of the program that Run starts, or would start, unless Prgm was pressed. */
    var firstSlots = programs.slotsBeginning(programs.slotToRun)
        private set

    private lateinit var setup: RunSetup

    var player = newPlayer(emptyList())
        private set

    private var lastSession = player.session
    private var futures = 0

    /** The breakpoints by the index of the robot. */
    private var lines = emptyMap<Int, Set<Breakpoint>>()

    init {
        listen()
    }

    /** Follows the sounds of the watched robot's brick. */
    private fun listen() = sound.listenTo(player.sounds, player.state.robots[player.watched].brick.kind)

    /** Whether the programs differ from those on the bricks. */
    val isChanged: Boolean get() = programs.written != loaded

    /** The slot of the program selected on the brick of the watched robot. */
    val slotOnBrick: Int get() = player.state.brick.selectedSlot.coerceAtMost(programs.count - 1)

    /**
     * Puts the robots at their starts in [world], with the current programs and [firstSlots] selected. [inputs] will be
     * replayed.
     */
    fun startNewRun(firstSlots: List<Int>, world: World = this.world, inputs: List<RecordedInput> = emptyList()) {
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
        escape.forget()
        idleDetector.disturb()
    }

    /** Shows the run's messages in [language]. Uses newly compiled programs if they have not changed. */
    fun setLanguage(language: Language) {
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
        player.setLanguage(language, loads)
    }

    /** Watches another [robot] of the world and plays the sound of its brick. */
    fun watch(robot: Int) {
        player.watched = robot
        listen()
        sound.skip()
    }

    /**
     * Called when the run may have changed. Follows a new session's sound, reports a new branch, and updates the
     * breakpoints.
     */
    fun update() {
        if (player.session !== lastSession) {
            val isAfresh = player.session.milliseconds == 0L && player.time == 0L
            lastSession = player.session
            listen()
            if (!isAfresh) sound.skip()
        }
        ear.follow(player, world)
        if (player.branchCount != futures) notices.show(Notice.NewBranch)
        futures = player.branchCount
        lines = world.robots.indices.associateWith { breakpoints(it) ?: lines[it].orEmpty() }
        player.breakpoints = lines.getValue(player.watched)
        player.otherBreakpoints = lines.filter { (robot, its) -> robot != player.watched && its.isNotEmpty() }
    }

    /** Of the program that [robot] runs; null for as before. */
    private fun breakpoints(robot: Int): Set<Breakpoint>? {
        val snippetOf = snippet(robot)
        return when {
            snippetOf != null -> programs.breakpointsOf(snippetOf)

            // The lines of a changed program differ from those of the running one.
            isChanged -> null
            else -> programs.breakpoints(world.robots[robot].name, player.state.robots[robot].brick.selectedSlot)
        }
    }

    /** The files with which the robots began this run, by their names. */
    val filesAtStart: Map<String, List<NxtFile>>
        get() = world.robots.zip(setup.loads).associate { (robot, load) -> robot.name to load.files }

    /**
     * Keeps what the robots have in their flash memories at the end of the known run. Returns whether that has changed.
     */
    fun keepFiles(): Boolean {
        if (player.isInPast || player.playback is PlaybackState.Seeking) return false
        return world.robots.zip(player.state.robots).map { (robot, state) ->
            val files = (state.brick as? HasFlash)?.files
            files != null && programs.keepFiles(robot.name, files)
        }.any { it }
    }

    /** The program that [robot] got to run at once, if it runs or was the last one to run. */
    fun snippet(robot: Int): Snippet? = player.snippet(robot) as? Snippet

    /** Plays the sounds since the last call, unless time passed too fast. */
    fun playNewSounds() {
        val isHeard =
            player.speed != RunSpeed.FASTEST &&
                (player.playback is PlaybackState.Playing || player.playback is PlaybackState.Stepping)
        val tones = ear.take()
        if (isHeard) sound.follow(tones) else sound.skip()
    }

    /** Plays a short tune for a solved task, unless the sound is off. */
    fun playTune() = sound.playTune()

    /** Drops the sounds since the last call. */
    fun skipSound() = sound.skip()

    /** Stops all sound. */
    fun silence() = sound.silence()

    /** Turns all sound [on] or off, and whether the run [isHeard]. */
    fun setSound(on: Boolean, isHeard: Boolean) {
        sound.muted = !on
        ear.isOn = on && isHeard
    }

    /** Plays one short sound of the current moment if the run is heard. */
    fun playMoment() {
        if (ear.isOn) RunSound.ofMoment(world, player.watched, player.state)?.let(sound::playMoment)
    }

    /** Plays [sample] unless the sound is off. */
    fun play(sample: SoundSample) = sound.playTones(sample.tones)

    /** While seeking, the shown state may be slightly old, so there is nothing to detect. */
    fun detectIdle() {
        if (player.playback !is PlaybackState.Seeking) idleDetector.passed(player.state)
    }

    /** Releases the session. No function may be called afterwards. */
    fun close() {
        sound.close()
        player.close()
    }

    private fun newPlayer(inputs: List<RecordedInput>): RunPlayer {
        setup = RunSetup(world, programs.loads(world, firstSlots), physics, preferences.language)
        return RunPlayer(setup, inputs)
    }
}

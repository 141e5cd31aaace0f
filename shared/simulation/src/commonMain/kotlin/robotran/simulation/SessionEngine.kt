package robotran.simulation

import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.infrared.InfraredRange
import robotran.simulation.config.SimulationLimits
import robotran.simulation.config.TraceHash
import robotran.simulation.explain.DeviationCause
import robotran.simulation.goal.GoalJudge
import robotran.simulation.goal.ProgramEvents
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.nxt.Loudness
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.robot.BrickPorts
import robotran.simulation.state.AmbientConditions
import robotran.simulation.state.LampState
import robotran.simulation.state.SessionState
import robotran.world.RobotPart
import robotran.world.World
import robotran.world.geometry.length

/** Advances the world and all robots of a session with their bricks, millisecond by millisecond. */
internal class SessionEngine(
    private val world: World,
    loads: List<RobotProgramSet>,
    physics: PhysicsEngine,
    language: Language,
) {
    private val simulation = Simulation(world, physics)
    private val air = InfraredAir(::reaches)
    private val network = BluetoothNetwork()

    /** The indices of the robots in the air, in its order: each brick that has infrared light itself, and each link to one. */
    private val withInfrared = world.robots.indices.flatMap { number ->
        val robot = world.robots[number].description
        if (robot.brick.hasInfrared) listOf(number) else robot.parts.filter(::isLink).map { number }
    }
    private val hash = TraceHash()
    private val judge = GoalJudge(world, physics.trigonometry, SimulationMessages.of(language))
    private var nextToTick = 0

    /** Whether the sensors have been read in this millisecond, which takes several ticks if a program pauses. */
    private var hasSensed = false
    private var latest: SessionState? = null

    /** In the world's order. */
    val robots = world.robots.indices.map {
        RobotInSession(
            it,
            world,
            loads.getOrElse(it) {
                RobotProgramSet(emptyList())
            },
            simulation,
            air,
            network,
            language,
        )
    }

    private val programEvents = ProgramEvents(robots.map { it.brick.sounds })

    /** Those of the [robots]; an array, since each millisecond asks all of them. */
    private val ports: Array<BrickPorts> = Array(robots.size) { robots[it].ports }

    /** Virtual time since the beginning. */
    var milliseconds = 0L
        private set

    init {
        simulation.scene.loudness = robots.map { robot -> Loudness { robot.loudness } }
        for (each in ports) each.begin()
        // The initial state, such as the volts on the display, counts for no goal.
        if (world.goals.isNotEmpty()) judgeGoals()
    }

    val state: SessionState get() = latest ?: snapshot().also { latest = it }
    val traceHash: String get() = hash.text

    /** Advances by one millisecond or the rest of one. It is not over if a program is paused in the middle of it. */
    fun tick() {
        latest = null
        if (!hasSensed) {
            for (each in ports) each.sense(milliseconds + 1)
            hasSensed = true
        }
        while (nextToTick < ports.size) {
            val brick = ports[nextToTick].brick
            brick.tick()
            if (brick.isPaused) return
            nextToTick++
        }
        nextToTick = 0
        hasSensed = false
        milliseconds++
        move()
        for (robot in robots) robot.addCallsTo(hash)
        if (milliseconds % SimulationLimits.MILLISECONDS_PER_EVALUATION == 0L && world.goals.isNotEmpty()) judgeGoals()
    }

    /** Applies an external input. */
    fun apply(input: SessionInput) {
        latest = null
        when (input) {
            is SessionInput.Press -> robots.getOrNull(input.robot)?.brick?.press(input.button)
            is SessionInput.Release -> robots.getOrNull(input.robot)?.brick?.release(input.button)
            SessionInput.Stop -> robots.forEach { it.brick.stopProgram() }

            is SessionInput.RunSnippet -> robots.getOrNull(input.robot)?.let {
                judge.abandon()
                it.brick.runSnippet(input.program)
            }

            is SessionInput.PlaceRobot -> if (input.robot in robots.indices) simulation.place(input.robot, input.pose)

            is SessionInput.PlaceBlock -> if (input.block in
                world.blocks.indices
            ) {
                simulation.placeBlock(input.block, input.pose)
            }

            is SessionInput.MoveLamp -> changeLamp(input.lamp) { it.copy(place = input.place) }
            is SessionInput.SwitchLamp -> changeLamp(input.lamp) { it.copy(on = input.on) }
            is SessionInput.ChangeAmbientLight -> simulation.light.changeAmbient(maxOf(0.0, input.light))
            is SessionInput.ChangeTemperature -> simulation.temperature = input.celsius
            is SessionInput.TouchSensor -> robots.getOrNull(input.robot)?.ports?.touch(input.port, input.pressed)
        }
    }

    /** Ends the run and decides the goals. */
    fun finish() {
        judge.finish(state)
        latest = latest?.copy(goals = judge.progress)
    }

    fun explain(): List<DeviationCause> = robots.flatMap { it.deviationCauses() }

    fun close() = simulation.close()

    private fun move() {
        for (each in ports) each.moveMotors(milliseconds)
        if (milliseconds % SimulationLimits.TICKS_PER_PHYSICS_STEP == 0L) {
            simulation.step()
            simulation.addTo(hash)
        }
    }

    private fun judgeGoals() {
        judge.observe(state, programEvents.take())
        latest = latest?.copy(goals = judge.progress)
    }

    private fun changeLamp(number: Int, change: (LampState) -> LampState) {
        val lamp = simulation.light.lamps.getOrNull(number) ?: return
        simulation.light.change(number, change(lamp))
    }

    /** Whether infrared light of one brick reaches another: through a room, or across a table. */
    private fun reaches(sender: Int, receiver: Int, range: InfraredRange): Boolean {
        if (range == InfraredRange.LONG) return true
        val from = simulation.machines[withInfrared[sender]].body.motion
        val to = simulation.machines[withInfrared[receiver]].body.motion
        return length(to.x - from.x, to.y - from.y) <= SHORT_INFRARED_RANGE
    }

    private fun isLink(part: RobotPart) = part.port != null && part.kind == SensorKind.RCX_LINK

    private fun snapshot() = SessionState(
        milliseconds = milliseconds,
        robots = robots.map { it.snapshot },
        blocks = simulation.blocks,
        lamps = simulation.light.lamps,
        ink = simulation.ink,
        goals = judge.progress,
        surroundings = AmbientConditions(simulation.light.ambient, simulation.temperature),
        trail = simulation.trail,
    )

    private companion object {
        /** Range of a brick's short-range infrared light, in centimetres. */
        const val SHORT_INFRARED_RANGE = 100.0
    }
}

package robotran.simulation

import robotran.brick.sensors.SensorKind
import robotran.simulation.config.SimulationLimits
import robotran.simulation.config.TraceHash
import robotran.simulation.ink.InkWriter
import robotran.simulation.ink.TrailWriter
import robotran.simulation.light.LightField
import robotran.simulation.light.PaperSurface
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.nxt.NxtScene
import robotran.simulation.physics.BodyMotion
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.addBarrier
import robotran.simulation.physics.addBlock
import robotran.simulation.physics.addWall
import robotran.simulation.robot.SimulatedRobot
import robotran.simulation.state.Ink
import robotran.simulation.state.TrailPiece
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.Sonar
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.centre
import robotran.world.geometry.normalHeading
import robotran.world.robot.things

/** The world outside the bricks: all objects and lights on the paper, and the robots' machines. */
internal class Simulation(private val world: World, engine: PhysicsEngine) {
    private val trigonometry = engine.trigonometry
    private val physics = engine.createWorld(SimulationLimits.PHYSICS)
    private val blockCentres = world.blocks.map { it.shape.centre }
    private val blockBodies: List<Int>
    private val blockMotions: MutableList<BodyMotion>
    private val pens = InkWriter(world.paper, world.robots.size)
    private val trails = TrailWriter(world.robots.size)

    /** Of each robot, by the part without its port. */
    private val lightSensors: List<Map<RobotPart, LightSensor>>
    private val freePlaces by lazy { FreeSpaceFinder(world, trigonometry) }

    /** In the world's order. */
    val machines: List<SimulatedRobot>
    val surface = PaperSurface(world.paper, world.marks, trigonometry)
    val light: LightField

    /** What the sensors of NXTs see and hear. */
    val scene: NxtScene

    /** In degrees Celsius. */
    var temperature = world.temperature

    init {
        world.walls.forEach(physics::addWall)
        world.barriers.forEach { physics.addBarrier(it.shape, trigonometry) }
        blockBodies = world.blocks.map { physics.addBlock(it, trigonometry) }
        blockMotions = blockBodies.mapTo(mutableListOf(), physics::motion)
        machines = world.robots.mapIndexed { number, robot ->
            val streams = NoiseStreams(world.seed, number)
            SimulatedRobot(physics, trigonometry, robot.start, robot.description, streams, world.realism)
        }
        light = LightField(world.lamps, world.ambientLight, physics, trigonometry)
        val soft = blockBodies.filterIndexed { number, _ -> world.blocks[number].friction >= Sonar.SOFT_FRICTION }
        scene = NxtScene(physics, surface, light, machines, soft.toSet(), ::beaconsBeside, trigonometry)
        lightSensors = world.robots.mapIndexed { number, robot ->
            val parts = robot.description.things.filterIsInstance<SensorPart>()
            parts.filter { it.sensor in RCX_LIGHTS }.associate { it.on(null) to LightSensor(number, it, this) }
        }
    }

    val ink: Ink get() = pens.ink
    val trail: List<TrailPiece> get() = trails.pieces

    /** The translation and rotation of each block so far. */
    val blocks: List<Pose>
        get() = blockMotions.mapIndexed { number, motion ->
            val centre = blockCentres[number]
            val turned = trigonometry.angle(motion.cosine, motion.sine) / RADIANS_PER_DEGREE
            Pose(motion.x - centre.x, motion.y - centre.y, normalHeading(turned))
        }

    /** The light sensor [part] of the robot at index [robot]. */
    fun lightSensor(robot: Int, part: SensorPart): LightSensor = lightSensors[robot].getValue(part.on(null))

    /** The lamps on all robots except the one at index [robot]. */
    fun beaconsBeside(robot: Int): List<Pair<Point, Double>> {
        if (world.robots.all { it.beacon == 0.0 }) return emptyList()
        return machines.indices.filter { it != robot && world.robots[it].beacon > 0 }
            .map { machines[it].body.pointAhead(0.0) to world.robots[it].beacon }
    }

    /** Advances by one physics step, with the wheel rotation since the last one. */
    fun step() {
        for (machine in machines) machine.beginStep()
        physics.step()
        for (machine in machines) machine.endStep()
        for ((number, body) in blockBodies.withIndex()) {
            if (!physics.isAtRest(body)) blockMotions[number] = physics.motion(body)
        }
        for (number in machines.indices) draw(number)
        forgetLight()
    }

    /** Puts the robot at index [robot] down elsewhere. */
    fun place(robot: Int, pose: Pose) {
        machines[robot].body.place(pose.onPaper())
        pens.lift(robot)
        trails.lift(robot)
        forgetLight()
    }

    /** Puts the block at index [block] down elsewhere; see [SessionInput.PlaceBlock] for the meaning of [pose]. */
    fun placeBlock(block: Int, pose: Pose) {
        val centre = blockCentres[block]
        val wanted = with(pose.onPaper()) { copy(x = x - centre.x, y = y - centre.y) }
        val free = freePlaces.nearest(block, wanted, machines.map { it.body.pose }, blocks)
        physics.place(blockBodies[block], centre.x + free.x, centre.y + free.y, free.heading * RADIANS_PER_DEGREE)
        blockMotions[block] = physics.motion(blockBodies[block])
        forgetLight()
    }

    private fun forgetLight() {
        for (sensors in lightSensors) for (sensor in sensors.values) sensor.forget()
    }

    /** Adds the data that identifies a run. */
    fun addTo(hash: TraceHash) {
        for (machine in machines) hash.add(machine.body.motion)
        for (motion in blockMotions) hash.add(motion)
    }

    fun close() = physics.close()

    private fun Pose.onPaper() = copy(x = x.coerceIn(0.0, world.paper.width), y = y.coerceIn(0.0, world.paper.height))

    private fun draw(number: Int) {
        val machine = machines[number]
        trails.move(number, machine.body.motion.x, machine.body.motion.y)
        val drawn = pens.move(number, machine.body.motion.x, machine.body.motion.y, machine.penIsDown)
        if (drawn != null) surface.ink.draw(drawn.first, drawn.second)
    }

    private fun TraceHash.add(motion: BodyMotion) {
        add(motion.x.toRawBits())
        add(motion.y.toRawBits())
        add(motion.cosine.toRawBits())
        add(motion.sine.toRawBits())
    }

    private companion object {
        val RCX_LIGHTS = setOf(SensorKind.LIGHT, SensorKind.RCX_LIGHT)
    }
}

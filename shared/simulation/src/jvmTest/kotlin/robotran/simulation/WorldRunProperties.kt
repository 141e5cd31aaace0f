package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.arbitraryWorlds
import robotran.world.file.readWorld
import robotran.world.geometry.Pose

/** Every valid world can run: the physics accepts every shape that the reader accepts. */
class WorldRunProperties :
    StringSpec({
        val driving = ScriptedProgram {
            activate(port = 1)
            penDown()
            motors(ScriptedProgram.FORWARD, 7)
            pause(5_000)
        }

        fun run(world: World, physics: PhysicsEngine) {
            val session =
                Session(world, world.robots.map { RobotProgramSet(listOf(driving)) }, physics, Language.ENGLISH)
            session.pressRun()
            session.advance(250)
            val places = session.state.robots.map { it.robot.pose } + session.state.blocks
            places.all { it.x.isFinite() && it.y.isFinite() && it.heading.isFinite() } shouldBe true
            session.finish()
            session.report().goals.size shouldBe world.goals.size
            session.close()
        }

        "every arbitrary world can be run" {
            val physics = loadPhysicsEngine()
            checkAll(100, arbitraryWorlds()) { run(it, physics) }
        }

        "blocks and robots can be put anywhere in every arbitrary world" {
            val physics = loadPhysicsEngine()
            val poses = Arb.bind(Arb.double(-500.0, 1500.0), Arb.double(-500.0, 1500.0), Arb.double(-720.0, 720.0)) {
                x,
                y,
                heading,
                ->
                Pose(x, y, heading)
            }
            checkAll(100, arbitraryWorlds(), Arb.list(poses, 1..12)) { world, places ->
                val session = Session(world, emptyList<RobotProgramSet>(), physics, Language.ENGLISH)
                for ((number, pose) in places.withIndex()) {
                    session.apply(SessionInput.PlaceBlock(number % maxOf(1, world.blocks.size), pose))
                    session.apply(SessionInput.PlaceRobot(number % world.robots.size, pose))
                    session.advance(20)
                }
                session.state.blocks.all { it.x.isFinite() && it.y.isFinite() && it.heading in -180.0..180.0 } shouldBe
                    true
                val again = Session.replay(
                    world,
                    emptyList(),
                    physics,
                    session.inputs,
                    session.state.milliseconds,
                    Language.ENGLISH,
                )
                again.traceHash shouldBe session.traceHash
                again.close()
                session.close()
            }
        }

        "a polygon that is not refused can be a barrier, a block, a mark and a region" {
            val physics = loadPhysicsEngine()
            // On a grid many edges meet, touch and overlap.
            val coordinate = Arb.choice(Arb.int(0..12).map { it / 2.0 }, Arb.double(0.0, 6.0, includeNaNs = false))
            val corners = Arb.list(Arb.bind(coordinate, coordinate) { x, y -> "[${x + 60}, ${y + 27}]" }, 3..8)
            var run = 0
            checkAll(1_000, corners) { polygon ->
                val shape = "\"polygon\": [${polygon.joinToString()}]"
                val world = """{ "format": "robotran-world", "version": 2, "title": "T", "paper": { "width": 100, "height": 80 },
                "robots": [{ "start": { "x": 40, "y": 30, "heading": 0 } }], "barriers": [{ $shape }], "blocks": [{ $shape }],
                "marks": [{ $shape }], "goals": [{ "kind": "stayOut", "region": { $shape } }] }"""
                val read = readWorld(world, Language.ENGLISH)
                if (read is WorldFileResult.Success) {
                    run(read.world, physics)
                    run++
                }
            }
            run shouldBeGreaterThan 60
        }
    })

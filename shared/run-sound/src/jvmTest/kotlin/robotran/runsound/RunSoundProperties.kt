package robotran.runsound

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.World
import robotran.world.file.arbitraryWorlds
import robotran.world.geometry.Pose

/** Whatever the world and the run, ears are not overwhelmed, and no loudspeaker gets what it cannot play. */
class RunSoundProperties :
    StringSpec({
        val poses = Arb.bind(Arb.double(-50.0, 300.0), Arb.double(-50.0, 300.0), Arb.double(-720.0, 720.0), ::Pose)

        /** A run in which a hand puts the robot to one of [places] after the other, and pushes it on by [drag]. */
        suspend fun tonesOf(world: World, robot: Int, places: List<Pose>, drag: Double): List<RunTone> {
            val session = Session(world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
            val sound = RunSound(world, robot)
            val tones = places.flatMap { place ->
                (0..<LOOKS).flatMap { look ->
                    session.apply(SessionInput.PlaceRobot(robot, place.copy(x = place.x + look * drag)))
                    session.advance(RunSound.LOOK_MILLISECONDS.toInt())
                    sound.observe(session.state)
                } + listOfNotNull(RunSound.ofMoment(world, robot, session.state))
            }
            session.close()
            return tones
        }

        "any run of any world has few tones in a second, all of which can be played" {
            checkAll(60, arbitraryWorlds(), Arb.list(poses, 1..4), Arb.double(-1.0, 1.0)) { world, places, drag ->
                val tones = tonesOf(world, world.robots.lastIndex, places, drag)
                tones.filterNot(::isPlayable).shouldBeEmpty()
                tones.forEach { first ->
                    tones.count {
                        it.milliseconds in first.milliseconds..<first.milliseconds + 1_000
                    } shouldBeLessThanOrEqual
                        MOST_IN_A_SECOND
                }
            }
        }

        "the same run sounds the same again" {
            checkAll(20, arbitraryWorlds(), Arb.list(poses, 1..3)) { world, places ->
                tonesOf(world, 0, places, 0.1) shouldBe tonesOf(world, 0, places, 0.1)
            }
        }
    })

private fun isPlayable(tone: RunTone): Boolean = tone.hertz in 31.0..20_000.0 && tone.duration in 10..1_000 &&
    tone.pan in -1.0..1.0 && tone.loudness in 0.0..1.0 && tone.milliseconds >= 0

private const val LOOKS = 60

/** A tick every 20 ms is the densest; the tone of a moment comes on top. */
private const val MOST_IN_A_SECOND = 55

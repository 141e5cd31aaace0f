package robotran.narration

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.double
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.file.arbitraryWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** Whatever is on the sheet, it is told in few and whole sentences. */
class NarrationProperties :
    StringSpec({
        "any robot anywhere in any world is told in bounded words" {
            val physics = loadPhysicsEngine()
            val poses = Arb.bind(Arb.double(-500.0, 1500.0), Arb.double(-500.0, 1500.0), Arb.double(-720.0, 720.0)) {
                x,
                y,
                heading,
                ->
                Pose(x, y, heading)
            }
            checkAll(100, arbitraryWorlds(), poses) { world, pose ->
                val session = Session(world, emptyList<RobotProgramSet>(), physics, Language.ENGLISH)
                val states = mutableListOf(session.state)
                for (robot in world.robots.indices) session.apply(SessionInput.PlaceRobot(robot, pose))
                repeat(5) {
                    session.advance(20)
                    states += session.state
                }
                session.close()
                val state = states.last()
                for (language in Language.entries) {
                    for (robot in world.robots.indices) {
                        check(
                            whereIs(robot, world, state, language),
                            MAX_PLACE_SENTENCES,
                        )
                    }
                    check(whatIsAt(Point(pose.x, pose.y), world, state, language), MAX_SPOT_SENTENCES)
                    check(storyOf(world, states, state.goals).sentences(language), RunStory.MAX_SENTENCES)
                }
            }
        }
    })

private fun check(sentences: List<String>, most: Int) {
    withClue(sentences) {
        (sentences.isNotEmpty()) shouldBe true
        sentences.size shouldBeLessThanOrEqual most
        for (sentence in sentences) {
            sentence.length shouldBeLessThan MAX_CHARACTERS
            sentence.isBlank() shouldBe false
            NOT_SAID.any { it in sentence } shouldBe false
        }
    }
}

/** Nothing of our code is said. */
private val NOT_SAID = listOf("NaN", "Infinity", "null", ", select", ", plural", "kotlin.")

/** Of where a robot is: itself, the four sides, what is under it, things, lamps, goals. */
private const val MAX_PLACE_SENTENCES = 3 + 4 + 2 + 5 + 3 + 7
private const val MAX_SPOT_SENTENCES = 5

/** A goal's own sentence may have 500. */
private const val MAX_CHARACTERS = 700

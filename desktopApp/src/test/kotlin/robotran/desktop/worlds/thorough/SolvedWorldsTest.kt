package robotran.desktop.worlds.thorough

import kotlinx.coroutines.runBlocking
import robotran.desktop.worlds.ShippedWorlds
import robotran.language.Language
import robotran.simulation.Session
import robotran.simulation.grade.Grade
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.pictures.sheetPng
import robotran.world.World
import java.io.File
import kotlin.test.Test
import kotlin.test.assertTrue

/**
 * Grades the shipped worlds and writes pictures to `build/pictures/worlds`. `WorldTasksTest` of `:shared:learning` runs
 * the solutions in `check`.
 */
class SolvedWorldsTest {
    private val pictures = File("build/pictures/worlds").apply { mkdirs() }
    private val physics = runBlocking { loadPhysicsEngine() }

    @Test
    fun `the solution of every world reaches all goals with several seeds`() {
        for ((name, world) in ShippedWorlds.withGoals) {
            for (solution in ShippedWorlds.solutionsOf(name)) {
                for (seed in SEEDS) {
                    val grade = grade(world.copy(seed = seed), solution, picture = name.takeIf { seed == SEEDS.first })
                    assertTrue(grade.passed, "$name, ${solution.name}, with seed $seed: ${grade.unmet}")
                }
            }
        }
    }

    @Test
    fun `an empty program reaches the goals of no world`() {
        for ((name, world) in ShippedWorlds.withGoals) {
            assertTrue(!grade(world, null).passed, name)
        }
    }

    private fun grade(world: World, program: File?, picture: String? = null): Grade {
        val session = Session(world, ShippedWorlds.loads(world, program), physics, Language.ENGLISH)
        try {
            if (picture != null) {
                pictures.resolve("$picture-start.png").writeBytes(sheetPng(world, session.state, PICTURE_WIDTH))
            }
            return session.runForGoals().also {
                if (picture != null) {
                    pictures.resolve("$picture-end.png").writeBytes(sheetPng(world, session.state, PICTURE_WIDTH))
                }
            }
        } finally {
            session.close()
        }
    }

    private companion object {
        val SEEDS = 1..3
        const val PICTURE_WIDTH = 900
    }
}

package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WorldGalleryTest {
    private val all = WorldGallery.worlds + WorldGallery.worlds.flatMap { it.harder }

    @Test
    fun `every world that comes with the app is in the gallery once`() {
        assertEquals(BuiltInWorlds.texts.keys, WorldGallery.worlds.map { it.name + WorldGallery.WORLD_FILE }.toSet())
        assertEquals(BuiltInWorlds.texts.size, WorldGallery.worlds.size)
        assertEquals(WorldGallery.worlds.sortedBy { it.level }, WorldGallery.worlds)
    }

    @Test
    fun `every world and variation has title and task in every language, in English those of its file`() {
        for (found in all) {
            for (language in Language.entries) {
                val world = found.world(language)
                val told = "${found.name} in ${language.ownName}"
                assertTrue(world.title.isNotBlank() && world.task.endsWith("."), told)
                if (language == Language.ENGLISH) {
                    assertEquals(found.plainWorld.title to found.plainWorld.task, world.title to world.task, told)
                } else {
                    assertNotEquals(found.plainWorld.task, world.task, told)
                }
            }
        }
    }

    @Test
    fun `every world with a task has two harder variations, and the free sheet has none`() {
        for (found in WorldGallery.worlds) {
            assertEquals(if (found.lesson == null) 0 else 2, found.harder.size, found.name)
            for (harder in found.harder) {
                assertEquals(found.harder - harder, WorldGallery.harderThan(harder))
                assertEquals(harder, WorldGallery.find(harder.world(Language.SPANISH)))
                assertEquals(harder, WorldGallery.named(harder.name))
            }
            assertEquals(found.harder, WorldGallery.harderThan(found))
        }
        assertEquals(listOf("plain"), WorldGallery.worlds.filter { it.lesson == null }.map { it.name })
        assertEquals(all.size, all.map { it.plainWorld.title }.toSet().size)
    }

    @Test
    fun `the figures in a task are the same in every language`() {
        for (found in all) {
            val parameters = Language.entries.map { language ->
                Regex("[0-9]+").findAll(found.world(language).task).map { it.value }.toSet()
            }
            assertEquals(1, parameters.toSet().size, "${found.name}: $parameters")
        }
    }

    @Test
    fun `a world is known again in any language and with another seed, but not when it was changed`() {
        val found = WorldGallery.worlds.first { it.name == "maze" }
        assertEquals(found, WorldGallery.find(found.world(Language.GERMAN).copy(seed = 77, realism = 1.0)))
        assertNull(WorldGallery.find(found.plainWorld.copy(goals = emptyList())))
        assertEquals(found, WorldGallery.named("maze"))
        assertNull(WorldGallery.named("nowhere"))
    }

    @Test
    fun `the bricks of the worlds are told by their names`() {
        val bricks = WorldGallery.worlds.map { it.plainWorld.robots.first().description.brick }.distinct()
        assertEquals(bricks.toSet(), WorldGallery.bricks.toSet())
    }

    @Test
    fun `a world is found by words of its title or task in the pupil's language`() {
        assertEquals(listOf("sumo", "nxt-sumo"), WorldGallery.search("SUMO", Language.ENGLISH).map { it.name })
        assertEquals(listOf("maze"), WorldGallery.search("wand labyrinth", Language.GERMAN).map { it.name })
        assertEquals(WorldGallery.worlds, WorldGallery.search("  ", Language.SPANISH))
        assertEquals(emptyList(), WorldGallery.search("submarine", Language.ENGLISH))
    }

    @Test
    fun `a world is found by its robot's line, brick and sensors, and one that tells of them comes first`() {
        val nxt = WorldGallery.worlds.filter { it.plainWorld.robots.first().description.brick == BrickKind.NXT }
        assertTrue(nxt.size >= 6)
        assertEquals(nxt.map { it.name }.toSet(), found("NXT", Language.GERMAN).toSet())
        val sonar = WorldGallery.search("sonar", Language.ENGLISH)
        assertEquals(sonar.sortedBy { "sonar" !in it.plainWorld.task }, sonar)
        val withSonar = nxt.filter { world ->
            world.plainWorld.robots.first().description.parts.any { it.kind == SensorKind.ULTRASONIC }
        }
        for ((word, language) in listOf("Abstand" to Language.GERMAN, "distancia" to Language.SPANISH)) {
            assertTrue(found(word, language).containsAll(withSonar.map { it.name }), word)
        }
        val line = WorldGallery.search("zeichenroboter", Language.GERMAN) {
            if (it == nxt.last()) "Zeichenroboter" else ""
        }
        assertEquals(listOf(nxt.last()), line)
    }

    @Test
    fun `a world is found by the language of its solution`() {
        assertEquals(setOf("maze", "line-loop", "table-edge"), found("nqc", Language.GERMAN).toSet())
        assertEquals(listOf("maze"), found("NQC labyrinth", Language.GERMAN))
    }

    @Test
    fun `a program that comes with a world is known by name and text`() {
        for (found in all) {
            val lesson = found.lesson ?: continue
            val solutions = lesson.solutions.map {
                if (it.name.endsWith(".java")) "Solution.java" else "solution.${it.name.substringAfterLast('.')}"
            }
            assertTrue(found.gives(lesson.program.name, lesson.program.text), found.name)
            for ((name, file) in solutions.zip(lesson.solutions)) assertTrue(found.gives(name, file.text), found.name)
            assertTrue(WorldGallery.isGiven(lesson.program.name, lesson.program.text))
            assertFalse(WorldGallery.isGiven(lesson.program.name, lesson.program.text + "beep\n"))
            assertFalse(WorldGallery.isGiven("my own.robo", lesson.solution.text))
        }
    }

    private fun found(query: String, language: Language) = WorldGallery.search(query, language).map { it.name }
}

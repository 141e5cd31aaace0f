package robotran.learning

import robotran.language.Language
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
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
            val figures = Language.entries.map { language ->
                Regex("[0-9]+").findAll(found.world(language).task).map { it.value }.toSet()
            }
            assertEquals(1, figures.toSet().size, "${found.name}: $figures")
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
    fun `a world is found by words of its title or task in the pupil's language`() {
        assertEquals(listOf("sumo", "nxt-sumo"), WorldGallery.search("SUMO", Language.ENGLISH).map { it.name })
        assertEquals(listOf("maze"), WorldGallery.search("wand labyrinth", Language.GERMAN).map { it.name })
        assertEquals(WorldGallery.worlds, WorldGallery.search("  ", Language.SPANISH))
        assertEquals(emptyList(), WorldGallery.search("submarine", Language.ENGLISH))
    }
}

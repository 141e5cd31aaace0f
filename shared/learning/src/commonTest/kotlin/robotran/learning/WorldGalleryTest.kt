package robotran.learning

import robotran.language.Language
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WorldGalleryTest {
    @Test
    fun `every world that comes with the app is in the gallery once`() {
        assertEquals(BuiltInWorlds.texts.keys, WorldGallery.worlds.map { it.name + WorldGallery.WORLD_FILE }.toSet())
        assertEquals(BuiltInWorlds.texts.size, WorldGallery.worlds.size)
        assertEquals(WorldGallery.worlds.sortedBy { it.level }, WorldGallery.worlds)
    }

    @Test
    fun `every world has title and task in every language`() {
        val names = WorldGallery.worlds.map { it.name }.toSet()
        for (language in Language.entries - Language.ENGLISH) {
            assertEquals(names, translatedTitles(language).keys, language.ownName)
            for (found in WorldGallery.worlds) {
                val world = found.world(language)
                assertTrue(world.title.isNotBlank() && world.task.endsWith("."), "${found.name} in ${language.ownName}")
                assertNotEquals(found.plainWorld.task, world.task, "${found.name} in ${language.ownName}")
            }
        }
    }

    @Test
    fun `the figures in a task are the same in every language`() {
        for (found in WorldGallery.worlds) {
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
        assertEquals(listOf("sumo"), WorldGallery.search("SUMO", Language.ENGLISH).map { it.name })
        assertEquals(listOf("maze"), WorldGallery.search("wand labyrinth", Language.GERMAN).map { it.name })
        assertEquals(WorldGallery.worlds, WorldGallery.search("  ", Language.SPANISH))
        assertEquals(emptyList(), WorldGallery.search("submarine", Language.ENGLISH))
    }
}

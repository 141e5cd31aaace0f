package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** What the goals of lessons and of the gallery's worlds say to a pupil. */
class GoalSentencesTest {
    @Test
    fun `the English text has what the goals of the worlds say and nothing else`() {
        for (told in told) {
            val written = told.worlds(Language.ENGLISH).flatMap(::saidIn)
            assertEquals(written.toSet(), told.goals(Language.ENGLISH).toSet(), told.name)
            assertEquals(told.goals(Language.ENGLISH).distinct(), told.goals(Language.ENGLISH), told.name)
        }
        assertTrue(told.count { it.goals(Language.ENGLISH).isNotEmpty() } >= LEAST)
    }

    @Test
    fun `every language has as many sentences with the same figures each in its own words`() {
        for (told in told) {
            val goals = Language.entries.map(told.goals)
            assertEquals(1, goals.map { it.size }.toSet().size, told.name)
            for (place in goals.first().indices) {
                val sentences = goals.map { it[place] }
                assertEquals(sentences.size, sentences.toSet().size, "${told.name}: $sentences")
                assertEquals(1, sentences.map { figuresIn(it) }.toSet().size, "${told.name}: $sentences")
                assertTrue(sentences.all { it.endsWith(".") && '`' !in it }, "${told.name}: $sentences")
            }
        }
    }

    @Test
    fun `all worlds say to a pupil what is in the text of their language`() {
        for (told in told) {
            for (language in Language.entries) {
                val said = told.worlds(language).flatMap(::saidIn).toSet()
                assertEquals(told.goals(language).toSet(), said, "${told.name} in ${language.ownName}")
            }
        }
    }

    @Test
    fun `the goals of a German lesson are German in both places`() {
        val edge = checkNotNull(Lessons.named("edge"))
        for (place in edge.places) {
            assertEquals(
                listOf("Halte am Rand.", "Fall nicht hinter dem schwarzen Streifen hinunter."),
                saidIn(edge.world(Language.GERMAN, place)),
            )
        }
        assertEquals("Stop at the edge.", saidIn(edge.world(Language.ENGLISH)).first())
    }

    @Test
    fun `a part of a goal is in the pupil's language too and so is that of a harder variation`() {
        val trail = checkNotNull(WorldGallery.named("ink-trail"))
        for (world in listOf(trail) + trail.harder) {
            assertEquals(listOf("Pita cuando lo hayas encontrado."), saidIn(world.world(Language.SPANISH)), world.name)
            assertEquals(listOf("Beep when you have found it."), saidIn(world.plainWorld), world.name)
        }
    }

    @Test
    fun `a world is known by its goals and not by what they say`() {
        val edge = checkNotNull(Lessons.named("edge"))
        val sumo = checkNotNull(WorldGallery.named("sumo"))
        for (language in Language.entries) {
            for (place in edge.places) assertEquals(place, edge.placeOf(edge.world(language, place)))
            assertEquals(edge, Lessons.lessonIn(edge.world(language)))
            assertEquals(sumo, WorldGallery.find(sumo.world(language)))
            // As an older version has saved it.
            assertEquals(sumo, WorldGallery.find(sumo.world(language).copy(goals = sumo.plainWorld.goals)))
        }
        val german = edge.world(Language.GERMAN)
        val other = german.goals.map { goal -> Goal(GoalCondition.EndWithin(seconds = 1), goal.says) }
        assertNull(Lessons.lessonIn(german.copy(goals = other)))
    }

    private companion object {
        /** Where a sentence made from the figures would not do. */
        const val LEAST = 30
        val told: List<Told> by lazy { lessonsTold() + galleryTold() }
    }
}

/** The [goals] in the texts of what is called [name], and its worlds. */
private class Told(val name: String, val worlds: (Language) -> List<World>, val goals: (Language) -> List<String>)

private fun lessonsTold(): List<Told> = Lessons.all.map { lesson ->
    val bricks = BrickKind.entries.map(lesson::on)
    Told(
        lesson.name,
        { language -> bricks.flatMap { on -> on.places.map { on.world(language, it) } } },
        { lesson.text(it).goals },
    )
}

private fun galleryTold(): List<Told> = WorldGallery.worlds.map { found ->
    Told(
        found.name,
        { language -> (listOf(found) + found.harder).map { it.world(language) } },
        { found.lesson?.text(it)?.goals.orEmpty() },
    )
}

private fun saidIn(world: World): List<String> = world.goals.flatMap(::saidBy)

private fun saidBy(goal: Goal): List<String> = listOfNotNull(goal.says) + goal.parts.flatMap(::saidBy)

private fun figuresIn(sentence: String): List<String> = Regex("[0-9]+").findAll(sentence).map { it.value }.toList()

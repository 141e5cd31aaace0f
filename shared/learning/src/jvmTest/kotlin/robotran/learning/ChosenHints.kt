package robotran.learning

import robotran.language.Language
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A wrong [program] at [lesson], which a file with [name] holds. */
internal class WrongTry(val lesson: Lesson, private val name: String, val program: String) {
    /** The condition that the first comment names: with `again`, it reaches the goals in the lesson's first place. */
    val expectedHint: String = program.lines().first().removePrefix("// hint: ")

    override fun toString(): String = "${lesson.name}/$name"
}

/** All wrong tries at lessons and at tasks of worlds. */
internal val allWrongTries: List<WrongTry> by lazy {
    (Lessons.all + worldTasks).flatMap { lesson ->
        wrongTriesAt(lesson).map { (name, program) -> WrongTry(lesson, name, program) }
    }
}

/** The wrong tries at [lesson], by file name. */
internal fun wrongTriesAt(lesson: Lesson): Map<String, String> = if (lesson in worldTasks) {
    wrongTriesInWorlds.filterKeys { "world/${it.substringBefore('/')}" == lesson.name }
} else {
    wrongTries.filterKeys { path ->
        val (strand, folder) = path.split('/')
        strand == lesson.strand && folder.substringAfter('-') == lesson.name
    }
}.mapKeys { it.key.substringAfterLast('/') }

/** Fails if one of [tries] reaches the goals in all places, or if fewer than nine of ten get the hint that is meant. */
internal suspend fun checkHints(tries: List<WrongTry>) {
    val chosen = tries.associateWith { chooseHint(it.lesson, runInAllPlaces(it.lesson, it.program), Language.ENGLISH) }
    assertEquals(emptyList(), chosen.filterValues { it == null }.keys.toList())
    val misses = chosen.mapValues { (_, hint) -> hint?.condition?.phrase ?: NUDGE }
        .filter { (wrong, phrase) -> phrase != wrong.expectedHint }
        .map { (wrong, phrase) -> "$wrong: $phrase, not ${wrong.expectedHint}" }
    val rate = 100 * (tries.size - misses.size) / tries.size
    println("${tries.size} wrong tries, $rate % with the hint that is meant; others:\n${misses.joinToString("\n")}")
    assertTrue(rate >= MIN_RATE, "$rate %: $misses")
}

private const val NUDGE = "nudge"
private const val MIN_RATE = 90

package robotran.assignments.doing

import robotran.assignments.java
import robotran.assignments.robolang
import robotran.language.ProgramLanguage
import robotran.projects.Assignment
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class AllowedTest {
    private val program =
        robolang("// beep\nFORWARD 10\nrepeat 4 times\n  turn left 90 degrees\n  show \"power\"\nend\n")

    @Test
    fun `words that only complete others are always allowed`() {
        val rules = Assignment("a", words = listOf("forward", "Repeat", "turn", "show"))
        assertEquals(emptyList(), forbiddenWords(rules, listOf(program)))
        assertFalse("end" in wordsToAllow || "left" in wordsToAllow)
        assertTrue(listOf("forward", "if", "bumper", "light", "random").all { it in wordsToAllow })
    }

    @Test
    fun `comments and texts have no words, and Java has none`() {
        val rules = Assignment("a", words = listOf("turn"))
        assertEquals(listOf("forward", "show", "repeat"), forbiddenWords(rules, listOf(program)))
        assertEquals(emptyList(), forbiddenWords(rules, listOf(java("class A { int forward; }"))))
        assertEquals(emptyList(), forbiddenWords(Assignment("a"), listOf(program)))
    }

    @Test
    fun `languages that are not named are not allowed`() {
        val programs = listOf(program, java("class A {}"))
        assertEquals(emptyList(), forbiddenLanguages(Assignment("a"), programs))
        val rules = Assignment("a", languages = listOf(ProgramLanguage.ROBOLANG))
        assertEquals(listOf(ProgramLanguage.JAVA), forbiddenLanguages(rules, programs))
    }

    @Test
    fun `the words of an NXT can be allowed or not, in either spelling, unless they are names`() {
        val senses = robolang("show distance\nif color == RED\n  show turned A\n  show loudness\nend\n")
        val rules = Assignment("a", words = listOf("show", "if", "Color"))
        assertEquals(listOf("distance", "loudness", "turned"), forbiddenWords(rules, listOf(senses)))
        val strict = Assignment("a", words = listOf("show", "if", "distance", "loudness", "turned"))
        assertEquals(listOf(NotAllowed.HasWord("prog.robo", "colour", 2)), notAllowedIn(strict, listOf(senses)))
        val names = robolang("forward distance\nvar loudness = 2\nconst distance = 3\n")
        assertEquals(listOf("forward", "var", "const"), forbiddenWords(rules, listOf(names)))
    }
}

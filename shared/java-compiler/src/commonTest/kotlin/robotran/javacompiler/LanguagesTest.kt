package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LanguagesTest {
    private suspend fun messageIn(messages: JavaMessages, statements: String): String {
        val sources = listOf(SourceFile("Robot.java", program(statements)))
        val first = assertIs<CompilationResult.Failure>(
            compiler().withLanguage(messages).compile(sources, library),
        ).diagnostics.first()
        return first.message
    }

    @Test
    fun `typical mistakes are told in Spanish`() = runTest {
        assertEquals(
            "Pon un \";\" al final de esta instrucción.",
            messageIn(JavaMessages.of(Language.SPANISH), "int x = 1"),
        )
        assertEquals(
            "No existe la variable \"x\". Declárala antes, por ejemplo con \"int x = 0;\".",
            messageIn(JavaMessages.of(Language.SPANISH), "x = 1;"),
        )
        assertEquals(
            "El Java del ladrillo no tiene \"switch\". Usa \"if\" y \"else if\".",
            messageIn(JavaMessages.of(Language.SPANISH), "int x = 1; switch (x) { case 1: x = 2; }"),
        )
    }

    @Test
    fun `typical mistakes are told in German`() = runTest {
        assertEquals(
            "Ans Ende dieser Anweisung gehört ein \";\".",
            messageIn(JavaMessages.of(Language.GERMAN), "int x = 1"),
        )
        assertEquals(
            "Es gibt keine Variable \"x\". Leg sie vorher an, zum Beispiel mit \"int x = 0;\".",
            messageIn(JavaMessages.of(Language.GERMAN), "x = 1;"),
        )
        assertEquals(
            "Das Java des Steins hat kein \"switch\". Nimm \"if\" und \"else if\".",
            messageIn(JavaMessages.of(Language.GERMAN), "int x = 1; switch (x) { case 1: x = 2; }"),
        )
    }
}

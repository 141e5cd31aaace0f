package robotran.robolang

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals

class LanguagesTest {
    @Test
    fun `typical mistakes are told in English`() = assertDiagnostics(
        Language.ENGLISH,
        "fowrard 20" to "There is no command \"fowrard\". Did you mean \"forward\"?",
        "forward" to "After \"forward\" comes a number, such as \"forward 20\".",
        "forward\nwait until left bumper" to "After \"forward\" comes a number, such as \"forward 20\". " +
            "To drive until something happens, write \"start forward\".",
        "repeat 4 times\nforward 20" to
            "This \"repeat\" has no \"end\". Write \"end\" on a line of its own where the block stops.",
    )

    @Test
    fun `typical mistakes are told in Spanish`() = assertDiagnostics(
        Language.SPANISH,
        "fowrard 20" to "No existe la orden \"fowrard\". ¿Querías decir \"forward\"?",
        "forward" to "Después de \"forward\" va un número, como en \"forward 20\".",
        "turn 90" to "Di hacia dónde hay que girar: \"turn left 90\" o \"turn right 90\".",
        "repeat 4 times\nforward 20" to
            "A este \"repeat\" le falta su \"end\". Escribe \"end\" en otra línea, donde termina el bloque.",
        "forward 1,5" to "Aquí un número lleva punto, no coma. Escribe 1.5.",
        "forward x" to "No existe la variable \"x\".",
        "x = 5" to "Todavía no existe la variable \"x\". Escribe \"var\" delante para declararla.",
        "wait -1 seconds" to "El robot no puede esperar menos que nada. Usa 0 o más.",
    )

    @Test
    fun `typical mistakes are told in German`() = assertDiagnostics(
        Language.GERMAN,
        "fowrard 20" to "Es gibt keinen Befehl \"fowrard\". Meinst du \"forward\"?",
        "forward" to "Nach \"forward\" kommt eine Zahl, zum Beispiel \"forward 20\".",
        "turn 90" to "Sag, in welche Richtung: \"turn left 90\" oder \"turn right 90\".",
        "repeat 4 times\nforward 20" to
            "Zu diesem \"repeat\" fehlt das \"end\". Schreib \"end\" in eine eigene Zeile, dort wo der Block aufhört.",
        "forward 1,5" to "Eine Zahl hat hier einen Punkt, kein Komma. Schreib 1.5.",
        "forward x" to "Es gibt keine Variable \"x\".",
        "x = 5" to "Es gibt noch keine Variable \"x\". Schreib \"var\" davor, um sie anzulegen.",
        "wait -1 seconds" to "Der Roboter kann nicht kürzer als gar nicht warten. Nimm 0 oder mehr.",
    )

    @Test
    fun `all test programs have the same mistakes in the same places in every language`() {
        for ((path, source) in testPrograms) {
            val english = diagnosticsOf(source, Language.ENGLISH)
            for (language in Language.entries - Language.ENGLISH) {
                val others = diagnosticsOf(source, language)
                assertEquals(
                    english.map { it.copy(message = "") },
                    others.map { it.copy(message = "") },
                    "$path in $language",
                )
                english.zip(others).forEach { (one, other) ->
                    assertNotEquals(one.message, other.message, "$path in $language")
                }
            }
        }
    }

    private fun assertDiagnostics(language: Language, vararg described: Pair<String, String>) =
        described.forEach { (source, message) ->
            assertEquals(message, assertIs<RobolangResult.Failure>(read(source, language)).diagnostics.first().message)
        }

    private fun diagnosticsOf(source: String, language: Language): List<Diagnostic> =
        when (val result = read(source, language)) {
            is RobolangResult.Success -> result.warnings
            is RobolangResult.Failure -> result.diagnostics
        }

    private fun read(source: String, language: Language) =
        compileRobolang("test.robo", source, robotFor(source), RobolangMessages.of(language))
}

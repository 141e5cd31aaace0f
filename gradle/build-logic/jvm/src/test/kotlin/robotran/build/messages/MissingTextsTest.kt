package robotran.build.messages

import kotlin.test.Test
import kotlin.test.assertEquals

class MissingTextsTest {
    private val files = mapOf(
        "lessons/drive/text.en.md" to "# Drive",
        "lessons/drive/text.de.md" to "# Fahren",
        "words/robolang.md" to "# forward\n\n- en: Drives.\n- de: Fährt.\n\n# beep\n\n- en: Beeps.",
        "api/sound.nqh" to "/**\n * - en: Plays.\n * - de: Spielt.\n */",
    )

    @Test
    fun `nothing is missing in English`() = assertEquals(emptyList(), missingTexts(files, "en"))

    @Test
    fun `sentences without a translation are counted`() =
        assertEquals(listOf("words/robolang.md: 1 sentences"), missingTexts(files, "de"))

    @Test
    fun `texts of their own are named`() = assertEquals(
        listOf("lessons/drive/text.fr.md", "words/robolang.md: 2 sentences", "api/sound.nqh: 1 sentences"),
        missingTexts(files, "fr"),
    )
}
